#include "app/commands.h"
#include "motion/problem.h"

namespace promenade::app {

void add_stats_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("stats", "(not in this version yet)");
  command->allow_extras();
  command->callback([] { throw OutsideError("stats is not in this version of Promenade yet"); });
}

}  // namespace promenade::app
