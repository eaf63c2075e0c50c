// What a person with markers and a tape measure would say about a generated walk.
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/gait/figure.h"
#include "motion/motion_set.h"

namespace promenade::motion {

// The joints of one side.
struct SideJoints {
  BodyJoint hip, knee, ankle, toe, shoulder, elbow, wrist;
  double strike;  // phase at which its heel strikes
};

inline constexpr SideJoints right_side{right_hip,      right_knee,  right_ankle, right_toe,
                                       right_shoulder, right_elbow, right_wrist, 0.4};
inline constexpr SideJoints left_side{left_hip,      left_knee,  left_ankle, left_toe,
                                      left_shoulder, left_elbow, left_wrist, 0.9};

// Largest and smallest of a figure.
struct Range {
  double least = INFINITY;
  double most = -INFINITY;

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

class WalkMeasures {
 public:
  static constexpr double degrees = 180 / 3.14159265358979323846;
  static constexpr int fine = 300;  // samples of a stride: five between two phases

  WalkMeasures(const MotionSet& set, const Cycle& cycle) : set_(set), cycle_(cycle) {}

  // At a phase, with the travel put back.
  WorldPose at(double phase) const {
    Pose pose = pose_at(set_, cycle_, phase);
    pose.root += seconds_at(set_, cycle_, phase) *
                 Eigen::Vector3d(cycle_.velocity.x(), 0, cycle_.velocity.y());
    return forward_kinematics(set_.skeleton, pose);
  }

  Eigen::Vector3d joint(const WorldPose& world, BodyJoint body) const {
    return world.positions.col(set_.body.joint[body]);
  }
  Eigen::Quaterniond turn(const WorldPose& world, BodyJoint body) const {
    return world.rotations[static_cast<std::size_t>(set_.body.joint[body])];
  }

  Eigen::Vector3d heel(const WorldPose& world, const SideJoints& side) const {
    return joint(world, side.ankle) + turn(world, side.ankle) * gait::heel_point;
  }
  // Of heel and toes.
  double lowest(const WorldPose& world, const SideJoints& side) const {
    const Eigen::Vector3d tip =
        joint(world, side.toe) +
        turn(world, side.toe) * (gait::toe_tip - Eigen::Vector3d(0, 0.017, 0));
    return std::min(heel(world, side).y(), tip.y());
  }

  // Degrees that the toes are up against the ground.
  double foot_pitch(const WorldPose& world, const SideJoints& side) const {
    return std::asin((turn(world, side.ankle) * Eigen::Vector3d::UnitZ()).y()) * degrees;
  }
  // Degrees that the foot is bent up against the shank.
  double dorsiflexion(const WorldPose& world, const SideJoints& side) const {
    const Eigen::Vector3d foot =
        turn(world, side.knee).conjugate() * (turn(world, side.ankle) * Eigen::Vector3d::UnitZ());
    return std::asin(foot.y()) * degrees;
  }
  double knee_flexion(const WorldPose& world, const SideJoints& side) const {
    const Eigen::Vector3d thigh = joint(world, side.knee) - joint(world, side.hip);
    const Eigen::Vector3d shank = joint(world, side.ankle) - joint(world, side.knee);
    return std::acos(thigh.normalized().dot(shank.normalized())) * degrees;
  }
  // Of the thigh against the vertical, forward.
  double hip_flexion(const WorldPose& world, const SideJoints& side) const {
    const Eigen::Vector3d thigh = joint(world, side.knee) - joint(world, side.hip);
    return std::atan2(thigh.z(), -thigh.y()) * degrees;
  }
  // Negative: bent the wrong way.
  double elbow_flexion(const WorldPose& world, const SideJoints& side) const {
    const Eigen::Vector3d fore = turn(world, side.shoulder).conjugate() *
                                 (joint(world, side.wrist) - joint(world, side.elbow));
    return std::atan2(fore.z(), -fore.y()) * degrees;
  }
  // Metres from the middle of the hand to the axis of the trunk, which is flatter than
  // wide: what lies beside it counts by 0.72.
  double hand_from_trunk(const WorldPose& world, const SideJoints& side) const {
    const Eigen::Vector3d hand =
        joint(world, side.wrist) + turn(world, side.wrist) * Eigen::Vector3d(0, -0.1, 0);
    const Eigen::Vector3d flat(0.72, 1, 1);
    const Eigen::Vector3d from = flat.cwiseProduct(joint(world, pelvis));
    const Eigen::Vector3d axis = flat.cwiseProduct(joint(world, neck)) - from;
    const Eigen::Vector3d reach = flat.cwiseProduct(hand) - from;
    const double share = std::clamp(reach.dot(axis) / axis.squaredNorm(), -0.2, 1.0);
    return (reach - share * axis).norm();
  }

  // Of a figure(world) over shares of a side's stride; its strike is at 0.
  template <class Figure>
  Range range(const SideJoints& side, double from, double to, Figure figure) const {
    Range found;
    const int samples = std::max(1, static_cast<int>(std::ceil((to - from) * fine)));
    for (int i = 0; i <= samples; ++i) {
      found.add(figure(at(side.strike + from + (to - from) * i / samples)));
    }
    return found;
  }

  // The farthest that the point which bears moves while the foot stands, metres.
  double slide(const SideJoints& side) const {
    const Eigen::Vector3d heel_at = heel(at(side.strike), side);
    const Eigen::Vector3d toe_at = joint(at(side.strike + 0.6), side.toe);
    return range(side, 0, 0.6,
                 [&](const WorldPose& world) {
                   return foot_pitch(world, side) > 0.2 ? (heel(world, side) - heel_at).norm()
                                                        : (joint(world, side.toe) - toe_at).norm();
                 })
        .most;
  }

  // The largest change of a joint's velocity from one phase to the next over the time
  // between them, m/s^2.
  double acceleration() const {
    Range found;
    for (int f = 0; f < set_.phases; ++f) {
      const auto when = [&](int k) { return seconds_at(set_, cycle_, k / 60.0); };
      const auto where = [&](int k) { return at(k / 60.0).positions; };
      const Eigen::Matrix3Xd after = (where(f + 1) - where(f)) / (when(f + 1) - when(f));
      const Eigen::Matrix3Xd before = (where(f) - where(f - 1)) / (when(f) - when(f - 1));
      found.add((after - before).colwise().norm().maxCoeff() / (0.5 * (when(f + 1) - when(f - 1))));
    }
    return found.most;
  }

 private:
  const MotionSet& set_;
  const Cycle& cycle_;
};

}  // namespace promenade::motion
