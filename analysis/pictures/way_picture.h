// A path over the ground that was wanted, and the way that was walked, from above (SVG).
#pragma once

#include <string>
#include <vector>

#include "motion/graph/graph_walk.h"

namespace promenade::analysis {

struct WayPicture {
  std::string title, note;                   // note: one line below
  Eigen::Matrix2Xd wanted;                   // x, z, metres; may be empty
  Eigen::Matrix2Xd walked;                   // of the pelvis, each frame
  std::vector<motion::LabelledPart> labels;  // of these frames; may be empty
};

// +Z is up on the paper, +X to the left, as for somebody who walks ahead.
std::string way_picture(const WayPicture& picture, const motion::MotionGraph& graph);

}  // namespace promenade::analysis
