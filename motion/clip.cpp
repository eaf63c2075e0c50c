#include "motion/clip.h"

#include <cassert>

#include "motion/degrees.h"

namespace promenade::motion {
namespace {

int axis_of(Channel channel) { return static_cast<int>(channel) % 3; }

int rotation_count(const JointChannels& joint) {
  int count = 0;
  for (const Channel channel : joint.channels) count += is_rotation(channel) ? 1 : 0;
  return count;
}

// A quaternion that stays in registers.
struct Turned {
  double w = 1, x = 0, y = 0, z = 0;
};

// The product with (cosine, sine * axis): at its right, which turns about an axis of its
// own, if side is 1; at its left, about an axis of its parent's, if side is -1.
Turned turned(const Turned& q, int axis, double sine, double cosine, double side) {
  const double s = sine, c = cosine, cross = side * sine;
  switch (axis) {
    case 0:
      return {q.w * c - q.x * s, q.x * c + q.w * s, q.y * c + q.z * cross, q.z * c - q.y * cross};
    case 1:
      return {q.w * c - q.y * s, q.x * c - q.z * cross, q.y * c + q.w * s, q.z * c + q.x * cross};
    default:
      return {q.w * c - q.z * s, q.x * c + q.y * cross, q.y * c - q.x * cross, q.z * c + q.w * s};
  }
}

// Joints of one frame, some at a time, so that their sines and cosines are made together.
class Poser {
 public:
  Poser(const Clip& clip, int frame, LocalPose& pose)
      : clip_(clip), values_(clip.values.col(frame).data()), pose_(pose) {}

  void pose_all() {
    const std::size_t joints = clip_.skeleton.joints.size();
    for (std::size_t j = 0; j < joints;) {
      const std::size_t end = gather(j);
      sines_cosines_of_degrees(halves_, count_, sines_, cosines_);
      count_ = 0;
      for (; j < end; ++j) pose_joint(j);
    }
  }

 private:
  static constexpr int most = 24;

  // Half the angles of as many joints as there is room for; gives the joint behind them.
  // Half an angle follows the angle through 720 degrees, so that neighbouring frames are
  // neighbours as quaternions too.
  std::size_t gather(std::size_t joint) {
    count_ = 0;
    for (; joint < clip_.channels.size(); ++joint) {
      const JointChannels& own = clip_.channels[joint];
      if (count_ + rotation_count(own) > most) break;
      const double* value = values_ + own.first_row;
      for (const Channel channel : own.channels) {
        if (is_rotation(channel)) halves_[count_++] = 0.5 * *value;
        ++value;
      }
    }
    return joint;
  }

  void pose_joint(std::size_t j) {
    const bool fixed_axes = !clip_.axes.empty();
    auto translation = pose_.translations.col(static_cast<Eigen::Index>(j));
    translation = clip_.skeleton.joints[j].offset;
    Turned q;
    const double* value = values_ + clip_.channels[j].first_row;
    for (const Channel channel : clip_.channels[j].channels) {
      if (is_rotation(channel)) {
        q = turned(q, axis_of(channel), sines_[count_], cosines_[count_], fixed_axes ? -1 : 1);
        ++count_;
      } else {
        translation(axis_of(channel)) = *value;
      }
      ++value;
    }
    Eigen::Quaterniond rotation(q.w, q.x, q.y, q.z);
    if (fixed_axes) rotation = clip_.axes[j].before * rotation * clip_.axes[j].after;
    pose_.rotations[j] = rotation;
  }

  const Clip& clip_;
  const double* values_;
  LocalPose& pose_;
  int count_ = 0;
  double halves_[most] = {}, sines_[most] = {}, cosines_[most] = {};
};

}  // namespace

std::string_view channel_name(Channel channel) {
  static constexpr std::string_view names[] = {"Xposition", "Yposition", "Zposition",
                                               "Xrotation", "Yrotation", "Zrotation"};
  return names[static_cast<std::size_t>(channel)];
}

void local_pose(const Clip& clip, int frame, LocalPose& pose) {
  assert(frame >= 0 && frame < clip.frames() && "the frame is in the clip");
  pose.rotations.resize(clip.skeleton.joints.size());
  pose.translations.resize(3, clip.skeleton.size());
  Poser(clip, frame, pose).pose_all();
}

LocalPose local_pose(const Clip& clip, int frame) {
  LocalPose pose;
  local_pose(clip, frame, pose);
  return pose;
}

WorldPose forward_kinematics(const Clip& clip, int frame) {
  return forward_kinematics(clip, local_pose(clip, frame));
}

WorldPose forward_kinematics(const Clip& clip, const LocalPose& pose) {
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
