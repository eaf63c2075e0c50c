// The heel, which captures do not have as a joint. When a heel strikes first, the foot
// turns about it until the sole is flat: the heel stands while ankle and toe move.
#pragma once

#include <Eigen/Dense>

namespace promenade::motion {

// Where the heel is in the plane of a foot, metres from the ankle: against the toe, and
// square to that, downwards (ours: a quarter of the foot's length behind the ankle and as
// low as the toe when the foot is flat).
struct Heel {
  double behind = 0, below = 0;
};

// From a foot that stands flat (world, Y up).
Heel find_heel(const Eigen::Vector3d& ankle, const Eigen::Vector3d& toe);

// The same with the heel at this height: the joint of a toe is a little over the sole.
Heel find_heel(const Eigen::Vector3d& ankle, const Eigen::Vector3d& toe, double height);

// The heel of the same foot in another pose.
Eigen::Vector3d heel_position(const Heel& heel, const Eigen::Vector3d& ankle,
                              const Eigen::Vector3d& toe);

}  // namespace promenade::motion
