// The subcommands of `promenade graph`, one file each.
#pragma once

#include <CLI/CLI.hpp>

namespace promenade::app {

void add_graph_distance(CLI::App& graph_command);

}  // namespace promenade::app
