#include "motion/leg_ik.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// The angle opposite to `far` in a triangle of these sides.
double angle_between(double a, double b, double far) {
  return std::acos(std::clamp((a * a + b * b - far * far) / (2 * a * b), -1.0, 1.0));
}

// The axis that the knee bends about: across the plane of the leg; of a straight leg,
// across the plane of shank and foot.
Vector3d knee_axis(const Vector3d& thigh, const Vector3d& shank, const Vector3d& foot) {
  Vector3d axis = thigh.cross(shank);
  if (axis.norm() < 1e-4 * thigh.norm() * shank.norm()) axis = foot.cross(shank);
  if (axis.norm() < 1e-9) return Vector3d::UnitX();
  return axis.normalized();
}

}  // namespace

LegJoints leg_joints(Side side) {
  if (side == Side::left) return {left_hip, left_knee, left_ankle, left_toe};
  return {right_hip, right_knee, right_ankle, right_toe};
}

void move_ankle(const Skeleton& skeleton, const BodyMap& body, Side side, const Vector3d& ankle,
                Pose& pose) {
  const WorldPose world = forward_kinematics(skeleton, pose);
  const LegJoints leg = leg_joints(side);
  const int hip = body.joint[leg.hip], knee = body.joint[leg.knee], foot = body.joint[leg.ankle];
  const auto at = [&](int joint) -> Vector3d { return world.positions.col(joint); };
  const Vector3d thigh = at(knee) - at(hip), shank = at(foot) - at(knee);
  const Vector3d wanted = ankle - at(hip);
  const double a = thigh.norm(), b = shank.norm();
  const double reach = std::clamp(wanted.norm(), std::abs(a - b) + 1e-6, a + b - 1e-6);
  const double bend = angle_between(a, b, (at(foot) - at(hip)).norm()) - angle_between(a, b, reach);
  const Vector3d axis = knee_axis(thigh, shank, at(body.joint[leg.toe]) - at(foot));
  const Quaterniond at_knee(Eigen::AngleAxisd(bend, axis));
  const Quaterniond at_hip = Quaterniond::FromTwoVectors(thigh + at_knee * shank, wanted);

  const auto turned = [&](int joint) { return world.rotations[static_cast<std::size_t>(joint)]; };
  const auto parent = [&](int joint) {
    return turned(skeleton.joints[static_cast<std::size_t>(joint)].parent);
  };
  const auto set = [&](int joint, const Quaterniond& above, const Quaterniond& own) {
    pose.rotations[static_cast<std::size_t>(joint)] = (above.conjugate() * own).normalized();
  };
  set(hip, parent(hip), at_hip * turned(hip));
  set(knee, at_hip * parent(knee), at_hip * at_knee * turned(knee));
  set(foot, at_hip * at_knee * parent(foot), turned(foot));
}

}  // namespace promenade::motion
