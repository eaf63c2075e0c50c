// Acclaim skeleton files (.asf): bones with their rest directions, axes and degrees of
// freedom. The motion of one is in an .amc file (motion/amc.h).
#pragma once

#include <string_view>

#include "motion/clip.h"

namespace promenade::motion {

// A joint is the start of its bone and has the bone's name; joint 0 is "root".
struct AsfSkeleton {
  std::string file;
  Skeleton skeleton;                    // file units; a joint's offset is its parent's bone
  std::vector<JointChannels> channels;  // J, degrees of freedom in the order of the file
  std::vector<JointAxes> axes;          // J
  int rows = 0;                         // values in a frame
  Eigen::Vector3d root_position = Eigen::Vector3d::Zero();  // the motion is added to it
  bool radians = false;                                     // how the file writes its angles
  std::optional<double> unit_m;  // 0.0254 / length, if it states a length
  std::vector<Problem> warnings;
};

// Throws InputError with every problem found. Limits, masses and unknown sections are
// left out. Nothing recurses on the depth of the tree.
AsfSkeleton read_asf(std::string_view text, const std::string& file);

}  // namespace promenade::motion
