// A motion graph as a picture (SVG): every take as a line of time with the places where it can
// be left and entered, transitions between them, and how many lead from style to style.
#pragma once

#include <string>

#include "motion/graph/motion_graph.h"

namespace promenade::analysis {

std::string graph_picture(const motion::BuiltGraph& built);

}  // namespace promenade::analysis
