// Every transition of a motion graph as a row of a table, used or refused.
#pragma once

#include <string>

#include "motion/graph/motion_graph.h"

namespace promenade::app {

// CSV with a header. Frames are those of the files. Transitions that were pruned are not in it.
std::string transitions_csv(const motion::BuiltGraph& built);

}  // namespace promenade::app
