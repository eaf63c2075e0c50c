#include "motion/gait/figure.h"

#include <cassert>
#include <string>

namespace promenade::motion::gait {
namespace {

using Eigen::Vector3d;

void add(Skeleton& skeleton, const std::string& name, const std::string& parent,
         const Vector3d& offset) {
  const int from = parent.empty() ? -1 : find_joint(skeleton, parent);
  assert((parent.empty() || from >= 0) && "parents come first");
  skeleton.joints.push_back({name, from, offset});
}

void add_tip(Skeleton& skeleton, const std::string& name, const Vector3d& offset) {
  skeleton.end_sites.push_back({find_joint(skeleton, name), offset});
}

void add_trunk(Skeleton& skeleton) {
  add(skeleton, "pelvis", "", Vector3d::Zero());
  add(skeleton, "spine", "pelvis", {0, 0.095, -0.015});
  add(skeleton, "chest", "spine", {0, 0.15, -0.01});
  add(skeleton, "neck", "chest", {0, 0.245, 0.0});
  add(skeleton, "head", "neck", {0, 0.105, 0.0});
  add_tip(skeleton, "head", {0, 0.175, 0.015});
}

void add_arm(Skeleton& skeleton, Side side) {
  const double x = sign_of(side);
  const std::string name = side == Side::left ? "left_" : "right_";
  add(skeleton, name + "clavicle", "chest", {0.025 * x, 0.205, 0.02});
  add(skeleton, name + "shoulder", name + "clavicle", {0.155 * x, -0.005, -0.02});
  add(skeleton, name + "elbow", name + "shoulder", {0, -0.29, 0});
  add(skeleton, name + "wrist", name + "elbow", {0, -0.255, 0});
  add_tip(skeleton, name + "wrist", {0, -0.175, 0});
}

void add_leg(Skeleton& skeleton, Side side) {
  const double x = sign_of(side);
  const std::string name = side == Side::left ? "left_" : "right_";
  add(skeleton, name + "hip", "pelvis", {0.088 * x, -0.045, 0});
  add(skeleton, name + "knee", name + "hip", {0, -thigh_length, 0});
  add(skeleton, name + "ankle", name + "knee", {0, -shank_length, 0});
  add(skeleton, name + "toe", name + "ankle", toe_joint);
  add_tip(skeleton, name + "toe", toe_tip);
}

}  // namespace

Skeleton make_skeleton() {
  Skeleton skeleton;
  add_trunk(skeleton);
  for (const Side side : {Side::left, Side::right}) add_arm(skeleton, side);
  for (const Side side : {Side::left, Side::right}) add_leg(skeleton, side);
  return skeleton;
}

BodyMap make_body_map(const Skeleton& skeleton) {
  BodyMap map;
  for (std::size_t b = 0; b < body_joint_count; ++b) {
    map.joint[b] = find_joint(skeleton, std::string(body_joint_name(static_cast<BodyJoint>(b))));
    assert(map.joint[b] >= 0 && "the skeleton has every joint of the body");
  }
  return map;
}

double sign_of(Side side) { return side == Side::left ? 1 : -1; }

}  // namespace promenade::motion::gait
