// A leg of two bones brought to a wanted place of its ankle.
#pragma once

#include "motion/body.h"

namespace promenade::motion {

enum class Side { left, right };

struct LegJoints {
  BodyJoint hip, knee, ankle, toe;
};
LegJoints leg_joints(Side side);

// The axis that the knee bends about, positive when the heel comes up, in the frame of
// the knee's parent: the mean over the poses, which a straight leg cannot turn over.
Eigen::Vector3d knee_axis(const Skeleton& skeleton, const BodyMap& body, Side side,
                          const std::vector<Pose>& poses);

// How far the knee is bent about that axis, radians; 0 is straight.
double knee_bend(const Skeleton& skeleton, const BodyMap& body, Side side,
                 const Eigen::Vector3d& axis, const WorldPose& world);

// Where an ankle is wanted, and how the foot is turned there, both in the world.
struct FootTarget {
  Eigen::Vector3d ankle;  // metres
  Eigen::Quaterniond rotation;
};

// Turns hip, knee and ankle of `pose` so that the foot comes to `target`, or as near as
// the leg reaches. The knee turns about `axis` only and never beyond straight.
void move_foot(const Skeleton& skeleton, const BodyMap& body, Side side,
               const Eigen::Vector3d& axis, const FootTarget& target, Pose& pose);

// The same where it is known what `pose` looks like (both legs moved or not: neither hangs from
// the other).
void move_foot(const Skeleton& skeleton, const BodyMap& body, Side side,
               const Eigen::Vector3d& axis, const FootTarget& target, const WorldPose& world,
               Pose& pose);

}  // namespace promenade::motion
