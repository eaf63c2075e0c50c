#include "app/commands.h"
#include "motion/problem.h"

namespace promenade::app {

void add_model_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("model", "(not in this version yet)");
  command->allow_extras();
  command->callback([] { throw OutsideError("model is not in this version of Promenade yet"); });
}

}  // namespace promenade::app
