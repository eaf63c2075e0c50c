#include "app/commands.h"
#include "motion/problem.h"

namespace promenade::app {

void add_check_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("check", "(not in this version yet)");
  command->allow_extras();
  command->callback([] { throw OutsideError("check is not in this version of Promenade yet"); });
}

}  // namespace promenade::app
