// The first half of a BVH file: the forest of joints, before one tree of it is
// chosen. Internal to the reader.
#pragma once

#include "motion/clip.h"
#include "motion/scanner.h"

namespace promenade::motion {

struct BvhHierarchy {
  Skeleton skeleton;                    // all trees, parents first; roots have parent -1
  std::vector<JointChannels> channels;  // rows counted over all trees
  int rows = 0;                         // values in a frame
};

// Reads up to the line MOTION, or gives up.
BvhHierarchy read_bvh_hierarchy(Scanner& in);

// Keeps the tree that holds the hips: the one whose joints make a body, else the
// one with the most joints. The others are named in a warning.
void keep_the_figure(BvhHierarchy& hierarchy, Scanner& in);

}  // namespace promenade::motion
