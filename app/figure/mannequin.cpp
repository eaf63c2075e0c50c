#include "app/figure/mannequin.h"

#include <algorithm>
#include <cmath>

namespace promenade::app {
namespace {

using Eigen::Vector3d;
using motion::BodyJoint;
using motion::WorldPose;

int body_index(const motion::BodyMap& body, BodyJoint joint) { return body.joint[joint]; }

std::size_t at(const motion::BodyMap& body, BodyJoint joint) {
  return static_cast<std::size_t>(body.joint[joint]);
}

// Calls visit(world) for a few poses of every cycle.
template <typename Visit>
void for_poses(const motion::MotionSet& set, const Visit& visit) {
  for (const motion::Cycle& cycle : set.cycles) {
    for (int k = 0; k < 12; ++k) {
      visit(motion::forward_kinematics(set.skeleton, motion::pose_at(set, cycle, k / 12.0)));
    }
  }
}

// The direction in a joint's own frame that points along `world` on average, over
// the poses in which the joint is not above `height`.
Vector3d mean_axis(const motion::MotionSet& set, BodyJoint joint, const Vector3d& world,
                   double height = INFINITY) {
  Vector3d sum = Vector3d::Zero();
  for_poses(set, [&](const WorldPose& pose) {
    if (pose.positions(1, body_index(set.body, joint)) > height) return;
    sum += pose.rotations[at(set.body, joint)].conjugate() * world;
  });
  return sum.norm() > 0 ? sum.normalized() : world;
}

// A low height of this joint, as it has when the foot stands.
double standing_height(const motion::MotionSet& set, BodyJoint joint) {
  std::vector<double> heights;
  for_poses(set, [&](const WorldPose& pose) {
    heights.push_back(pose.positions(1, body_index(set.body, joint)));
  });
  const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 5);
  std::nth_element(heights.begin(), low, heights.end());
  return *low;
}

double walking_height(const motion::MotionSet& set) {
  double sum = 0;
  int count = 0;
  for_poses(set, [&](const WorldPose& pose) {
    sum += pose.positions(1, body_index(set.body, motion::head));
    ++count;
  });
  return sum / std::max(count, 1);
}

}  // namespace

Mannequin make_mannequin(const motion::MotionSet& set) {
  Mannequin made;
  made.body = set.body;
  made.scale = motion::leg_length(set.skeleton, set.body) / 0.85;
  made.height = walking_height(set) + 0.21 * made.scale;
  made.head_up = mean_axis(set, motion::head, Vector3d::UnitY());
  made.head_ahead = mean_axis(set, motion::head, Vector3d::UnitZ());
  made.ankle_height = std::clamp(standing_height(set, motion::left_ankle), 0.03, 0.15);
  made.toe_height = std::clamp(standing_height(set, motion::left_toe), 0.0, made.ankle_height);
  const std::array<BodyJoint, 2> ankles = {motion::left_ankle, motion::right_ankle};
  const std::array<BodyJoint, 2> toes = {motion::left_toe, motion::right_toe};
  constexpr double flat = 0.005;  // metres over standing
  for (std::size_t side = 0; side < 2; ++side) {
    const double ankle = standing_height(set, ankles[side]) + flat;
    made.foot_ahead[side] = mean_axis(set, ankles[side], Vector3d::UnitZ(), ankle);
    made.foot_up[side] = mean_axis(set, ankles[side], Vector3d::UnitY(), ankle);
    const double toe = standing_height(set, toes[side]) + flat;
    made.toe_ahead[side] = mean_axis(set, toes[side], Vector3d::UnitZ(), toe);
    made.toe_up[side] = mean_axis(set, toes[side], Vector3d::UnitY(), toe);
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
