// `promenade graph`: motion graphs.
#include "app/commands.h"
#include "app/commands/graph_parts.h"

namespace promenade::app {

void add_graph_command(CLI::App& program) {
  CLI::App* command = program.add_subcommand("graph", "Motion graphs of captures");
  command->require_subcommand(1);
  add_graph_distance(*command);
}

}  // namespace promenade::app
