// The subcommands of `promenade graph`, and what they share. For app/commands/graph*.cpp only.
#pragma once

#include <CLI/CLI.hpp>

#include "motion/graph/motion_graph.h"

namespace promenade::app {

void add_graph_build(CLI::App& graph_command);

// A file that `graph build` wrote. Throws InputError or OutsideError.
motion::MotionGraph load_graph(const std::string& file);

}  // namespace promenade::app
