#include "app/commands.h"
#include "motion/problem.h"

namespace promenade::app {

void add_run_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("run", "(not in this version yet)");
  command->allow_extras();
  command->callback([] { throw OutsideError("run is not in this version of Promenade yet"); });
}

}  // namespace promenade::app
