// The commands of docs/commands.md. Each file in app/commands/ declares one: it adds
// itself to the parser and does its work in the callback. Errors are thrown and
// become messages and exit codes in main, once.
#pragma once

#include <CLI/CLI.hpp>

namespace promenade::app {

void add_doctor_command(CLI::App& program);
void add_set_command(CLI::App& program);
void add_motion_command(CLI::App& program);
void add_graph_command(CLI::App& program);
void add_check_command(CLI::App& program);
void add_plan_command(CLI::App& program);
void add_roster_command(CLI::App& program);
void add_run_command(CLI::App& program);
void add_simulate_command(CLI::App& program);
void add_replay_command(CLI::App& program);
void add_model_command(CLI::App& program);
void add_pack_command(CLI::App& program);
void add_amend_command(CLI::App& program);
void add_prereg_command(CLI::App& program);
void add_report_command(CLI::App& program);
void add_export_command(CLI::App& program);
void add_power_command(CLI::App& program);
void add_stats_command(CLI::App& program);
void add_withdraw_command(CLI::App& program);
void add_merge_command(CLI::App& program);
// Those of the contract that are not there yet: they say so, exit code 1.
void add_missing_commands(CLI::App& program);

}  // namespace promenade::app
