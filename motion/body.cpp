#include "motion/body.h"

namespace promenade::motion {

std::string_view body_joint_name(BodyJoint joint) {
  static constexpr std::array<std::string_view, body_joint_count> names = {
      "pelvis",        "chest",       "neck",       "head",           "left_clavicle",
      "left_shoulder", "left_elbow",  "left_wrist", "right_clavicle", "right_shoulder",
      "right_elbow",   "right_wrist", "left_hip",   "left_knee",      "left_ankle",
      "left_toe",      "right_hip",   "right_knee", "right_ankle",    "right_toe"};
  return names[joint];
}

int body_parent(BodyJoint joint) {
  static constexpr std::array<int, body_joint_count> parents = {
      -1,     pelvis,         chest,          neck,         //
      chest,  left_clavicle,  left_shoulder,  left_elbow,   //
      chest,  right_clavicle, right_shoulder, right_elbow,  //
      pelvis, left_hip,       left_knee,      left_ankle,   //
      pelvis, right_hip,      right_knee,     right_ankle};
  return parents[joint];
}

Eigen::Matrix<double, 3, body_joint_count> body_positions(const BodyMap& body,
                                                          const WorldPose& world) {
  Eigen::Matrix<double, 3, body_joint_count> positions;
  for (int b = 0; b < body_joint_count; ++b) {
    positions.col(b) = world.positions.col(body.joint[static_cast<std::size_t>(b)]);
  }
  return positions;
}

namespace {

double bone(const Skeleton& skeleton, int from, int to) {
  double length = 0;
  for (int j = to; j > from && j >= 0; j = skeleton.joints[static_cast<std::size_t>(j)].parent) {
    length += skeleton.joints[static_cast<std::size_t>(j)].offset.norm();
  }
  return length;
}

}  // namespace

double leg_length(const Skeleton& skeleton, const BodyMap& body) {
  const auto& at = body.joint;
  return 0.5 * (bone(skeleton, at[left_hip], at[left_knee]) +
                bone(skeleton, at[left_knee], at[left_ankle]) +
                bone(skeleton, at[right_hip], at[right_knee]) +
                bone(skeleton, at[right_knee], at[right_ankle]));
}

}  // namespace promenade::motion
