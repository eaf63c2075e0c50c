#include "motion/plain_clip.h"

#include "motion/zyx_angles.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

bool turns(const JointChannels& joint) {
  for (const Channel channel : joint.channels) {
    if (is_rotation(channel)) return true;
  }
  return false;
}

// Positions first, as in the clip, then Z, Y, X if the joint turns.
std::vector<Channel> plain_channels(const JointChannels& joint) {
  std::vector<Channel> channels;
  for (const Channel channel : joint.channels) {
    if (!is_rotation(channel)) channels.push_back(channel);
  }
  if (turns(joint)) {
    channels.insert(channels.end(),
                    {Channel::z_rotation, Channel::y_rotation, Channel::x_rotation});
  }
  return channels;
}

}  // namespace

Clip plain_clip(const Clip& clip) {
  if (clip.axes.empty()) return clip;
  Clip plain;
  plain.file = clip.file;
  plain.format = clip.format;
  plain.skeleton = clip.skeleton;
  plain.frame_time = clip.frame_time;
  plain.unit_m = clip.unit_m;
  plain.warnings = clip.warnings;
  int rows = 0;
  for (const JointChannels& joint : clip.channels) {
    plain.channels.push_back({plain_channels(joint), rows});
    rows += static_cast<int>(plain.channels.back().channels.size());
  }
  plain.values = Eigen::MatrixXd::Zero(rows, clip.frames());
  LocalPose pose;
  for (int f = 0; f < clip.frames(); ++f) {
    local_pose(clip, f, pose);
    for (std::size_t j = 0; j < plain.channels.size(); ++j) {
      int row = plain.channels[j].first_row;
      for (const Channel channel : plain.channels[j].channels) {
        if (is_rotation(channel)) break;
        plain.values(row++, f) =
            pose.translations(static_cast<int>(channel), static_cast<Eigen::Index>(j));
      }
      if (!turns(plain.channels[j])) continue;
      const Vector3d before =
          f > 0 ? Vector3d(plain.values.block<3, 1>(row, f - 1)) : Vector3d::Zero();
      plain.values.block<3, 1>(row, f) = zyx_angles(pose.rotations[j].toRotationMatrix(), before);
    }
  }
  return plain;
}

}  // namespace promenade::motion
