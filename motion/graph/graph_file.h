// A motion graph as bytes: the file that `graph build` writes, with the captured motion in it, so
// that it needs nothing beside it. Little-endian, doubles as they are, with a checksum.
#pragma once

#include <string>
#include <string_view>

#include "motion/graph/motion_graph.h"

namespace promenade::motion {

std::string to_bytes(const MotionGraph& graph);

// Throws InputError with `file` as its place when the bytes are not a whole graph.
MotionGraph graph_from_bytes(std::string_view bytes, const std::string& file);

}  // namespace promenade::motion
