#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "app/commands.h"
#include "app/desk/desk_window.h"
#include "app/desk/words.h"
#include "app/usage_error.h"
#include "motion/problem.h"

namespace {

int run(int argc, char** argv) {
  CLI::App program("Promenade runs user studies of motion-style interfaces.", "promenade");
  program.set_version_flag("--version", "promenade " PROMENADE_VERSION);
  program.require_subcommand(0, 1);
  program.failure_message(promenade::app::usage_error);
  namespace app = promenade::app;
  app::DeskWindowSetting desk;
  desk.language = app::language_of_system();
  program.add_option("--studies", desk.studies, "the folder of the studies that the desk shows");
  program.add_option("--language", desk.language, "of the desk: en or ja")
      ->check(CLI::IsMember(app::desk_languages()));
  program.add_option("--trace", desk.trace, "where its controls are, for tests")->group("");
  program.footer("Without a command the desk is opened: studies are made, run and watched there.");
  program.callback([&] {
    if (program.get_subcommands().empty()) app::open_desk(desk);
  });
  const app::Command root(&program);
  app::add_check_command(root);
  app::add_plan_command(root);
  app::add_roster_command(root);
  app::add_run_command(root);
  app::add_simulate_command(root);
  app::add_pack_command(root);
  app::add_amend_command(root);
  app::add_replay_command(root);
  app::add_prereg_command(root);
  app::add_report_command(root);
  app::add_export_command(root);
  app::add_power_command(root);
  app::add_stats_command(root);
  app::add_withdraw_command(root);
  app::add_merge_command(root);
  app::add_set_command(root);
  app::add_motion_command(root);
  app::add_graph_command(root);
  app::add_model_command(root);
  app::add_doctor_command(root);
  app::add_monitor_command(root);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  return 0;
}

// A full disk behind stdout only shows when the buffer is emptied.
int with_output(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  std::fputs("promenade: cannot write the output; make room or send it somewhere else\n", stderr);
  return code == 0 ? 1 : code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of the disk
  try {
    return with_output(run(argc, argv));
  } catch (const promenade::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "promenade: %s\n", error.what());
    return 1;
  }
}
