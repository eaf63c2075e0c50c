// The commands of docs/commands.md. Each file in app/commands/ declares one: it adds
// itself to the parser and does its work in the callback. Errors are thrown and
// become messages and exit codes in main, once.
#pragma once

#include "app/command_line.h"

namespace promenade::app {

void add_doctor_command(Command program);
void add_set_command(Command program);
void add_motion_command(Command program);
void add_graph_command(Command program);
void add_check_command(Command program);
void add_plan_command(Command program);
void add_roster_command(Command program);
void add_run_command(Command program);
void add_simulate_command(Command program);
void add_replay_command(Command program);
void add_model_command(Command program);
void add_pack_command(Command program);
void add_amend_command(Command program);
void add_prereg_command(Command program);
void add_report_command(Command program);
void add_export_command(Command program);
void add_power_command(Command program);
void add_stats_command(Command program);
void add_withdraw_command(Command program);
void add_merge_command(Command program);
void add_monitor_command(Command program);

}  // namespace promenade::app
