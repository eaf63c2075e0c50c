#include "motion/graph/clouds.h"

#include <cassert>

#include "motion/body_mapping.h"
#include "motion/models/centre_of_mass.h"

namespace promenade::motion {
namespace {

constexpr double foot_emphasis = 3;

// The joint of the body at which the mass of a segment's end is looked at.
BodyJoint nearest_joint(int point) {
  if (point == Segment::mid_shoulder) return chest;
  if (point == Segment::mid_hip) return pelvis;
  if (point == Segment::head_top) return head;
  return static_cast<BodyJoint>(point);
}

bool of_foot(int joint) {
  return joint == left_ankle || joint == left_toe || joint == right_ankle || joint == right_toe;
}

}  // namespace

Eigen::VectorXd body_weights() {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(body_joint_count);
  for (const Segment& segment : body_segments()) {
    mass(nearest_joint(segment.proximal)) += segment.mass * (1 - segment.centre);
    mass(nearest_joint(segment.distal)) += segment.mass * segment.centre;
  }
  for (int b = 0; b < body_joint_count; ++b) {
    if (of_foot(b)) mass(b) *= foot_emphasis;
  }
  return mass / mass.sum();
}

Clouds joint_clouds(const Clip& clip, bool z_up) {
  return joint_clouds(clip, z_up, 0, clip.frames());
}

Clouds joint_clouds(const Clip& clip, bool z_up, int first, int frames) {
  const int joints = clip.skeleton.size();
  const Eigen::Matrix3d turn = to_y_up(z_up);
  Clouds clouds;
  clouds.weights = Eigen::VectorXd::Ones(joints);
  clouds.points.resize(3, static_cast<Eigen::Index>(joints) * frames);
  for (int f = 0; f < frames; ++f) {
    clouds.points.middleCols(static_cast<Eigen::Index>(f) * joints, joints) =
        turn * forward_kinematics(clip, first + f).positions;
  }
  return clouds;
}

Eigen::VectorXd joint_weights(const Skeleton& skeleton, const BodyMap& body) {
  const double least = 0.01 / skeleton.size();
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(skeleton.size(), least);
  const Eigen::VectorXd mass = body_weights();
  for (std::size_t b = 0; b < body_joint_count; ++b) {
    weights(body.joint[b]) += mass(static_cast<Eigen::Index>(b));
  }
  return weights / weights.sum();
}

Clouds joint_clouds(const Take& take, const Eigen::VectorXd& weights) {
  assert(weights.size() == take.skeleton.size() && "one weight for every joint");
  const Eigen::Index joints = weights.size();
  Clouds clouds;
  clouds.weights = weights;
  clouds.points.resize(3, joints * take.frames());
  WorldPose world;
  for (int f = 0; f < take.frames(); ++f) {
    forward_kinematics(take.skeleton, take.poses[static_cast<std::size_t>(f)], world);
    clouds.points.middleCols(f * joints, joints) = world.positions;
  }
  return clouds;
}

}  // namespace promenade::motion
