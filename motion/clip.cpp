#include "motion/clip.h"

#include <cassert>
#include <cmath>

namespace promenade::motion {
namespace {

int axis_of(Channel channel) { return static_cast<int>(channel) % 3; }

// Turns about the axis' own frame: channels of a joint multiply from left to right.
void turn(Eigen::Quaterniond& rotation, Channel channel, double degrees) {
  // Captures may count turns: the angle is brought near 0 before it loses digits.
  const double half = 0.5 * std::remainder(degrees, 720.0) * M_PI / 180;
  Eigen::Quaterniond step(std::cos(half), 0, 0, 0);
  step.vec()(axis_of(channel)) = std::sin(half);
  rotation = rotation * step;
}

}  // namespace

std::string_view channel_name(Channel channel) {
  static constexpr std::string_view names[] = {"Xposition", "Yposition", "Zposition",
                                               "Xrotation", "Yrotation", "Zrotation"};
  return names[static_cast<std::size_t>(channel)];
}

LocalPose local_pose(const Clip& clip, int frame) {
  assert(frame >= 0 && frame < clip.frames() && "the frame is in the clip");
  const std::size_t joints = clip.skeleton.joints.size();
  LocalPose pose;
  pose.rotations.assign(joints, Eigen::Quaterniond::Identity());
  pose.translations.resize(3, static_cast<Eigen::Index>(joints));
  for (std::size_t j = 0; j < joints; ++j) {
    auto translation = pose.translations.col(static_cast<Eigen::Index>(j));
    translation = clip.skeleton.joints[j].offset;
    int row = clip.channels[j].first_row;
    for (const Channel channel : clip.channels[j].channels) {
      const double value = clip.values(row++, frame);
      if (is_rotation(channel)) {
        turn(pose.rotations[j], channel, value);
      } else {
        translation(axis_of(channel)) = value;
      }
    }
  }
  return pose;
}

WorldPose forward_kinematics(const Clip& clip, int frame) {
  const LocalPose pose = local_pose(clip, frame);
  WorldPose world;
  world.positions.resize(3, clip.skeleton.size());
  world.rotations.resize(pose.rotations.size());
  for (int j = 0; j < clip.skeleton.size(); ++j) {
    const auto index = static_cast<std::size_t>(j);
    const int parent = clip.skeleton.joints[index].parent;
    if (parent < 0) {
      world.positions.col(j) = pose.translations.col(j);
      world.rotations[index] = pose.rotations[index];
      continue;
    }
    const Eigen::Quaterniond& turned = world.rotations[static_cast<std::size_t>(parent)];
    world.positions.col(j) = world.positions.col(parent) + turned * pose.translations.col(j);
    world.rotations[index] = turned * pose.rotations[index];
  }
  return world;
}

}  // namespace promenade::motion
