#include "app/commands.h"
#include "motion/problem.h"

namespace promenade::app {

void add_missing_commands(Command program) {
  for (const char* name : {"monitor"}) {
    Command command = program.add_subcommand(name, "(not in this version yet)");
    command.allow_extras();
    command.callback([name] {
      throw OutsideError(std::string(name) + " is not in this version of Promenade yet");
    });
  }
}

}  // namespace promenade::app
