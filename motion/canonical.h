// From poses over time to the canonical form of a cycle (docs/methods.md, 1).
#pragma once

#include <functional>

#include "motion/motion_set.h"

namespace promenade::motion {

// Normalised time (0 to 1) at every phase of the grid: F+1 values.
Eigen::VectorXd normalised_times(const MotionSet& set, const Cycle& cycle);

// Splits the horizontal path of the pelvis (2 x F+1, metres, left and ahead, at the
// phases of the grid and the closing one) into the mean velocity and a sway whose
// mean over time is 0. The keytimes of the cycle are already there.
void set_planar_path(const MotionSet& set, const Eigen::Matrix2Xd& path, Cycle& cycle);

// Samples one loop at the common phases. `pose` gives the pose at a time from 0 to
// keytimes.back(), with Y up and walking along +Z; the pose at the end is the one
// at 0, moved horizontally. Fills rotations, root, velocity, seconds and keytimes.
Cycle canonical_cycle(const MotionSet& set, const std::vector<double>& keytimes,
                      const std::function<Pose(double seconds)>& pose);

}  // namespace promenade::motion
