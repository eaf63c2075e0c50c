// `promenade graph`: from captures to motion graphs, and walks along them.
#include "app/commands.h"
#include "app/commands/graph_parts.h"
#include "motion/files.h"
#include "motion/graph/graph_file.h"

namespace promenade::app {

motion::MotionGraph load_graph(const std::string& file) {
  motion::MotionGraph graph = motion::graph_from_bytes(read_file(file), file);
  if (graph.nodes.empty()) {
    throw InputError(file, "is a motion graph without a walk; build it again");
  }
  return graph;
}

void add_graph_command(Command program) {
  Command command =
      program.add_subcommand("graph", "Motion graphs: transitions between captures, walks");
  command.require_subcommand();
  add_graph_distance(command);
  add_graph_build(command);
  add_graph_walk(command);
  add_graph_path(command);
}

}  // namespace promenade::app
