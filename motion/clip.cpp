#include "motion/clip.h"

#include <cassert>

#include "motion/degrees.h"

namespace promenade::motion {
namespace {

int axis_of(Channel channel) { return static_cast<int>(channel) % 3; }

// The turn of a channel. Its sign follows the angle through 720 degrees, so that
// neighbouring frames are neighbours as quaternions too.
Eigen::Quaterniond turn(Channel channel, double degrees) {
  const SineCosine half = sine_cosine_of_degrees(0.5 * degrees);
  Eigen::Quaterniond step(half.cosine, 0, 0, 0);
  step.vec()(axis_of(channel)) = half.sine;
  return step;
}

}  // namespace

std::string_view channel_name(Channel channel) {
  static constexpr std::string_view names[] = {"Xposition", "Yposition", "Zposition",
                                               "Xrotation", "Yrotation", "Zrotation"};
  return names[static_cast<std::size_t>(channel)];
}

void local_pose(const Clip& clip, int frame, LocalPose& pose) {
  assert(frame >= 0 && frame < clip.frames() && "the frame is in the clip");
  const std::size_t joints = clip.skeleton.joints.size();
  pose.rotations.resize(joints);
  pose.translations.resize(3, static_cast<Eigen::Index>(joints));
  const bool fixed_axes = !clip.axes.empty();
  for (std::size_t j = 0; j < joints; ++j) {
    auto translation = pose.translations.col(static_cast<Eigen::Index>(j));
    translation = clip.skeleton.joints[j].offset;
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    int row = clip.channels[j].first_row;
    for (const Channel channel : clip.channels[j].channels) {
      const double value = clip.values(row++, frame);
      if (!is_rotation(channel)) {
        translation(axis_of(channel)) = value;
      } else {
        const Eigen::Quaterniond step = turn(channel, value);
        rotation = fixed_axes ? step * rotation : rotation * step;
      }
    }
    if (fixed_axes) rotation = clip.axes[j].before * rotation * clip.axes[j].after;
    pose.rotations[j] = rotation;
  }
}

LocalPose local_pose(const Clip& clip, int frame) {
  LocalPose pose;
  local_pose(clip, frame, pose);
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
