#include "motion/leg_ik.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Never quite straight: a straight knee has no side to bend to.
constexpr double least_bend = 0.04;  // radians

struct Hinge {
  Vector3d axis;      // of the knee, world, length 1
  double bend = 0;    // radians from a straight leg, measured about the axis
  double wanted = 0;  // the bend at which the ankle is as far from the hip as wanted
};

Hinge find_hinge(const Vector3d& axis, const Vector3d& thigh, const Vector3d& shank,
                 double distance) {
  const double along = thigh.dot(axis) * shank.dot(axis);
  const Vector3d upper = thigh - axis * thigh.dot(axis);
  const Vector3d lower = shank - axis * shank.dot(axis);
  const double span = upper.norm() * lower.norm();
  Hinge hinge{axis, std::atan2(upper.cross(lower).dot(axis), upper.dot(lower)), 0};
  const double dot = 0.5 * (distance * distance - thigh.squaredNorm() - shank.squaredNorm());
  hinge.wanted = std::acos(std::clamp((dot - along) / span, -1.0, std::cos(least_bend)));
  return hinge;
}

}  // namespace

LegJoints leg_joints(Side side) {
  if (side == Side::left) return {left_hip, left_knee, left_ankle, left_toe};
  return {right_hip, right_knee, right_ankle, right_toe};
}

Vector3d knee_axis(const Skeleton& skeleton, const BodyMap& body, Side side,
                   const std::vector<Pose>& poses) {
  const LegJoints leg = leg_joints(side);
  const auto knee = static_cast<std::size_t>(body.joint[leg.knee]);
  const auto above = static_cast<std::size_t>(skeleton.joints[knee].parent);
  Vector3d sum = Vector3d::Zero();
  for (const Pose& pose : poses) {
    const WorldPose world = forward_kinematics(skeleton, pose);
    const auto at = [&](BodyJoint part) -> Vector3d {
      return world.positions.col(body.joint[part]);
    };
    const Vector3d across = (at(leg.knee) - at(leg.hip)).cross(at(leg.ankle) - at(leg.knee));
    sum += world.rotations[above].conjugate() * across;
  }
  return sum.norm() > 0 ? sum.normalized() : Vector3d::UnitX();
}

void move_foot(const Skeleton& skeleton, const BodyMap& body, Side side, const Vector3d& axis,
               const FootTarget& target, Pose& pose) {
  const WorldPose world = forward_kinematics(skeleton, pose);
  const LegJoints leg = leg_joints(side);
  const int hip = body.joint[leg.hip], knee = body.joint[leg.knee], foot = body.joint[leg.ankle];
  const auto at = [&](int joint) -> Vector3d { return world.positions.col(joint); };
  const Vector3d thigh = at(knee) - at(hip), shank = at(foot) - at(knee);
  const Vector3d wanted = target.ankle - at(hip);
  const auto thigh_joint =
      static_cast<std::size_t>(skeleton.joints[static_cast<std::size_t>(knee)].parent);
  const Hinge hinge = find_hinge(world.rotations[thigh_joint] * axis, thigh, shank, wanted.norm());
  const Quaterniond at_knee(Eigen::AngleAxisd(hinge.wanted - hinge.bend, hinge.axis));
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
  set(foot, at_hip * at_knee * parent(foot), target.rotation);
}

}  // namespace promenade::motion
