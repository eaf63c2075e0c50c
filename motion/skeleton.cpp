#include "motion/skeleton.h"

#include <cassert>

namespace promenade::motion {

int find_joint(const Skeleton& skeleton, const std::string& name) {
  for (int j = 0; j < skeleton.size(); ++j) {
    if (skeleton.joints[static_cast<std::size_t>(j)].name == name) return j;
  }
  return -1;
}

void forward_kinematics(const Skeleton& skeleton, const Pose& pose, WorldPose& world) {
  assert(pose.rotations.size() == skeleton.joints.size() && "a pose turns every joint");
  world.positions.resize(3, skeleton.size());
  world.rotations.resize(skeleton.joints.size());
  for (int j = 0; j < skeleton.size(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    const Joint& joint = skeleton.joints[index];
    if (joint.parent < 0) {
      world.positions.col(j) = pose.root;
      world.rotations[index] = pose.rotations[index];
      continue;
    }
    const auto parent = static_cast<std::size_t>(joint.parent);
    world.positions.col(j) =
        world.positions.col(joint.parent) + world.rotations[parent] * joint.offset;
    world.rotations[index] = world.rotations[parent] * pose.rotations[index];
  }
}

WorldPose forward_kinematics(const Skeleton& skeleton, const Pose& pose) {
  WorldPose world;
  forward_kinematics(skeleton, pose, world);
  return world;
}

}  // namespace promenade::motion
