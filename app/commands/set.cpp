#include "app/commands.h"
#include "motion/problem.h"

namespace promenade::app {

void add_set_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("set", "(not in this version yet)");
  command->allow_extras();
  command->callback([] { throw OutsideError("set is not in this version of Promenade yet"); });
}

}  // namespace promenade::app
