// `promenade graph`: from captures to motion graphs, and walks along them.
#include <algorithm>
#include <filesystem>

#include "analysis/format.h"
#include "app/commands.h"
#include "app/commands/graph_parts.h"
#include "motion/did_you_mean.h"
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

void check_labels(const std::string& option, const std::vector<std::string>& wanted,
                  const std::vector<std::string>& known) {
  std::vector<Problem> problems;
  for (const std::string& label : wanted) {
    if (std::find(known.begin(), known.end(), label) != known.end()) continue;
    problems.push_back({option, 0, 0,
                        "there is no label '" + label + "'" + did_you_mean(label, known) +
                            "; there are: " + analysis::listed(known),
                        Severity::error});
  }
  if (!problems.empty()) throw InputError(problems);
}

void check_outputs(const std::vector<std::string>& outputs,
                   const std::vector<std::string>& inputs) {
  std::vector<std::string> taken = inputs;
  for (const std::string& out : outputs) {
    if (out.empty()) continue;
    for (const std::string& other : taken) {
      std::error_code ignored;
      if (out == other || std::filesystem::equivalent(out, other, ignored)) {
        throw InputError(out, "would be overwritten; name another file to write");
      }
    }
    taken.push_back(out);
  }
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
