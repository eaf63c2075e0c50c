#include "app/figure/mannequin.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace promenade::app {
namespace {

using Eigen::Vector3d;
using motion::BodyJoint;
using motion::WorldPose;

using Poses = std::vector<WorldPose>;

// A few poses of every cycle.
Poses poses_of(const motion::MotionSet& set) {
  Poses poses;
  for (const motion::Cycle& cycle : set.cycles) {
    for (int k = 0; k < 12; ++k) {
      poses.push_back(
          motion::forward_kinematics(set.skeleton, motion::pose_at(set, cycle, k / 12.0)));
    }
  }
  return poses;
}

// The direction in a joint's own frame that points along `world` on average, over
// the poses in which the joint is not above `height`.
Vector3d mean_axis(const Poses& poses, int joint, const Vector3d& world, double height = INFINITY) {
  Vector3d sum = Vector3d::Zero();
  for (const WorldPose& pose : poses) {
    if (pose.positions(1, joint) > height) continue;
    sum += pose.rotations[static_cast<std::size_t>(joint)].conjugate() * world;
  }
  return sum.norm() > 0 ? sum.normalized() : world;
}

// A low height of this joint, as it has when the foot stands.
double standing_height(const Poses& poses, int joint) {
  std::vector<double> heights;
  for (const WorldPose& pose : poses) heights.push_back(pose.positions(1, joint));
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 5);
  std::nth_element(heights.begin(), low, heights.end());
  return *low;
}

double mean_height(const Poses& poses, int joint) {
  double sum = 0;
  for (const WorldPose& pose : poses) sum += pose.positions(1, joint);
  return sum / static_cast<double>(poses.size());
}

}  // namespace

Mannequin make_mannequin(const motion::MotionSet& set) {
  return make_mannequin(set.skeleton, set.body, poses_of(set));
}

Mannequin make_mannequin(const motion::Skeleton& skeleton, const motion::BodyMap& body,
                         const std::vector<motion::WorldPose>& poses) {
  assert(!poses.empty() && "somebody is to be drawn");
  const auto joint = [&body](BodyJoint one) { return body.joint[one]; };
  Mannequin made;
  made.body = body;
  made.scale = motion::leg_length(skeleton, body) / 0.85;
  made.height = mean_height(poses, joint(motion::head)) + 0.21 * made.scale;
  made.head_up = mean_axis(poses, joint(motion::head), Vector3d::UnitY());
  made.head_ahead = mean_axis(poses, joint(motion::head), Vector3d::UnitZ());
  made.ankle_height = std::clamp(standing_height(poses, joint(motion::left_ankle)), 0.03, 0.15);
  made.toe_height =
      std::clamp(standing_height(poses, joint(motion::left_toe)), 0.0, made.ankle_height);
  const std::array<int, 2> ankles = {joint(motion::left_ankle), joint(motion::right_ankle)};
  const std::array<int, 2> toes = {joint(motion::left_toe), joint(motion::right_toe)};
  constexpr double flat = 0.005;  // metres over standing
  for (std::size_t side = 0; side < 2; ++side) {
    const double ankle = standing_height(poses, ankles[side]) + flat;
    made.foot_ahead[side] = mean_axis(poses, ankles[side], Vector3d::UnitZ(), ankle);
    made.foot_up[side] = mean_axis(poses, ankles[side], Vector3d::UnitY(), ankle);
    const double toe = standing_height(poses, toes[side]) + flat;
    made.toe_ahead[side] = mean_axis(poses, toes[side], Vector3d::UnitZ(), toe);
    made.toe_up[side] = mean_axis(poses, toes[side], Vector3d::UnitY(), toe);
  }
  return made;
}

void turn(std::vector<Part>& parts, float yaw) {
  const Eigen::Matrix3f rotation =
      Eigen::AngleAxisf(yaw, Eigen::Vector3f::UnitY()).toRotationMatrix();
  for (Part& part : parts) {
    part.a = rotation * part.a;
    part.b = rotation * part.b;
    part.thin = rotation * part.thin;
  }
}

}  // namespace promenade::app
