// The distances of all pairs of windows of a motion graph's takes, laid end to end, as a picture
// (SVG): dark where frames are alike, with the matches that transitions were made of.
#pragma once

#include <string>

#include "motion/graph/map_picture.h"
#include "motion/graph/motion_graph.h"

namespace promenade::analysis {

// The map of a graph's takes, small enough to look at.
motion::MapPicture distances_of(const motion::MotionGraph& graph);

// `map` is distances_of(built.graph).
std::string distance_picture(const motion::BuiltGraph& built, const motion::MapPicture& map);

}  // namespace promenade::analysis
