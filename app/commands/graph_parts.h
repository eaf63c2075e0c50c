// The subcommands of `promenade graph`, and what they share. For app/commands/graph*.cpp only.
#pragma once

#include "app/command_line.h"
#include "app/print.h"
#include "motion/graph/graph_walk.h"

namespace promenade::app {

void add_graph_distance(Command graph_command);
void add_graph_build(Command graph_command);
void add_graph_walk(Command graph_command);
void add_graph_path(Command graph_command);

inline constexpr double most_walk_seconds = 3600;

// A file that `graph build` wrote. Throws InputError or OutsideError.
motion::MotionGraph load_graph(const std::string& file);

// Throws InputError about `option` for every label that is not known, with what it may have been.
void check_labels(const std::string& option, const std::vector<std::string>& wanted,
                  const std::vector<std::string>& known);

// Throws InputError when a file that is to be written is one of those that are read, or is to be
// written twice. Empty names are none.
void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

struct WrittenWalk {
  const motion::MotionGraph& graph;
  const motion::GraphWalk& walk;
  std::string title, note = {};  // of the picture
  Eigen::Matrix2Xd wanted = {};  // the path that it follows; may be empty
};

// As a capture (.bvh) and, unless `picture` is empty, as a picture of its way (.svg).
void write_walk(const WrittenWalk& written, const std::string& out, const std::string& picture);

// Frames, labels over time, and where each edge comes from.
Json walk_json(const motion::MotionGraph& graph, const motion::GraphWalk& walk);
std::string walk_text(const motion::MotionGraph& graph, const motion::GraphWalk& walk,
                      const std::string& out);

}  // namespace promenade::app
