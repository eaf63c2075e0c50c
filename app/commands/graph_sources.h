// What people name as the captures of a motion graph: files, a recipe of `set build`, or a motion
// set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "motion/graph/graph_takes.h"

namespace promenade::app {

struct GraphSources {
  std::vector<std::string> names;  // "walk.bvh", "sad=walk.bvh", "recipe.toml", "builtin:A"
  std::string folder;              // of a recipe's captures; empty: as it says
  std::optional<double> rate;      // frames a second
};

struct NamedGraphTakes {
  std::string name;  // of the graph: of its recipe, its set or its first file
  std::vector<motion::GraphTake> takes;
  std::vector<Problem> warnings;
};

// Shows progress. Throws InputError with all problems of all files.
NamedGraphTakes load_graph_sources(const GraphSources& sources);

}  // namespace promenade::app
