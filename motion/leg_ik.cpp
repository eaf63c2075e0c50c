#include "motion/leg_ik.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Never quite straight, but for knees that are: a straight knee has no side to bend to.
constexpr double least_bend = 0.04;  // radians

struct Leg {
  int hip, knee, foot;    // joints
  Vector3d thigh, shank;  // hip to knee, knee to ankle, world
  Vector3d axis;          // of the knee, world, length 1

  // Seen along the axis.
  Vector3d upper() const { return thigh - axis * thigh.dot(axis); }
  Vector3d lower() const { return shank - axis * shank.dot(axis); }

  // Radians from a straight leg, measured about the axis.
  double bend() const { return std::atan2(upper().cross(lower()).dot(axis), upper().dot(lower())); }
  // The bend at which the ankle is so far from the hip.
  double bend_at(double distance) const {
    const double along = thigh.dot(axis) * shank.dot(axis);
    const double span = upper().norm() * lower().norm();
    const double dot = 0.5 * (distance * distance - thigh.squaredNorm() - shank.squaredNorm());
    const double least = std::clamp(bend(), 0.0, least_bend);
    return std::acos(std::clamp((dot - along) / span, -1.0, std::cos(least)));
  }
};

Leg find_leg(const Skeleton& skeleton, const BodyMap& body, Side side, const Vector3d& axis,
             const WorldPose& world) {
  const LegJoints joints = leg_joints(side);
  Leg leg{body.joint[joints.hip], body.joint[joints.knee], body.joint[joints.ankle], {}, {}, {}};
  leg.thigh = world.positions.col(leg.knee) - world.positions.col(leg.hip);
  leg.shank = world.positions.col(leg.foot) - world.positions.col(leg.knee);
  const int above = skeleton.joints[static_cast<std::size_t>(leg.knee)].parent;
  leg.axis = world.rotations[static_cast<std::size_t>(above)] * axis;
  return leg;
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

double knee_bend(const Skeleton& skeleton, const BodyMap& body, Side side, const Vector3d& axis,
                 const WorldPose& world) {
  return find_leg(skeleton, body, side, axis, world).bend();
}

void move_foot(const Skeleton& skeleton, const BodyMap& body, Side side, const Vector3d& axis,
               const FootTarget& target, Pose& pose) {
  move_foot(skeleton, body, side, axis, target, forward_kinematics(skeleton, pose), pose);
}

void move_foot(const Skeleton& skeleton, const BodyMap& body, Side side, const Vector3d& axis,
               const FootTarget& target, const WorldPose& world, Pose& pose) {
  const Leg leg = find_leg(skeleton, body, side, axis, world);
  const Vector3d wanted = target.ankle - world.positions.col(leg.hip);
  const Quaterniond at_knee(Eigen::AngleAxisd(leg.bend_at(wanted.norm()) - leg.bend(), leg.axis));
  const Quaterniond at_hip = Quaterniond::FromTwoVectors(leg.thigh + at_knee * leg.shank, wanted);

  const auto turned = [&](int joint) { return world.rotations[static_cast<std::size_t>(joint)]; };
  const auto parent = [&](int joint) {
    return turned(skeleton.joints[static_cast<std::size_t>(joint)].parent);
  };
  const auto set = [&](int joint, const Quaterniond& above, const Quaterniond& own) {
    pose.rotations[static_cast<std::size_t>(joint)] = (above.conjugate() * own).normalized();
  };
  set(leg.hip, parent(leg.hip), at_hip * turned(leg.hip));
  set(leg.knee, at_hip * parent(leg.knee), at_hip * at_knee * turned(leg.knee));
  set(leg.foot, at_hip * at_knee * parent(leg.foot), target.rotation);
}

}  // namespace promenade::motion
