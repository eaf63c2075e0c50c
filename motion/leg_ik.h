// A leg of two bones brought to a wanted place of its ankle.
#pragma once

#include "motion/body.h"

namespace promenade::motion {

enum class Side { left, right };

struct LegJoints {
  BodyJoint hip, knee, ankle, toe;
};
LegJoints leg_joints(Side side);

// Turns hip and knee of `pose` so that the ankle comes to `ankle` (world, metres), or
// as near as the leg reaches. The knee stays in the plane that it bends in, and the
// foot keeps its direction in the world.
void move_ankle(const Skeleton& skeleton, const BodyMap& body, Side side,
                const Eigen::Vector3d& ankle, Pose& pose);

}  // namespace promenade::motion
