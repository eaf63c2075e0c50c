// The body of 20 joints that D, the features and the figure use (docs/methods.md, 1;
// ours: [O] says 20 joints and lists none). A capture's further joints are kept
// for playback and export only.
#pragma once

#include <array>
#include <string_view>

#include "motion/skeleton.h"

namespace promenade::motion {

enum BodyJoint {
  pelvis,
  chest,
  neck,
  head,
  left_clavicle,
  left_shoulder,
  left_elbow,
  left_wrist,
  right_clavicle,
  right_shoulder,
  right_elbow,
  right_wrist,
  left_hip,
  left_knee,
  left_ankle,
  left_toe,
  right_hip,
  right_knee,
  right_ankle,
  right_toe,
  body_joint_count
};

// "left_clavicle" and so on.
std::string_view body_joint_name(BodyJoint joint);

// The joint of the body that this one hangs from; -1 for the pelvis.
int body_parent(BodyJoint joint);

struct BodyMap {
  std::array<int, body_joint_count> joint{};      // index into the skeleton
  std::array<bool, body_joint_count> borrowed{};  // no joint of its own: placed by its parent
};

// 3 x 20, metres: the body's joints out of all joints.
Eigen::Matrix<double, 3, body_joint_count> body_positions(const BodyMap& body,
                                                          const WorldPose& world);

// Hip to knee to ankle, mean of both legs, metres.
double leg_length(const Skeleton& skeleton, const BodyMap& body);

}  // namespace promenade::motion
