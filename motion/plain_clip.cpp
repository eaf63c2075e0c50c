#include "motion/plain_clip.h"

#include <cmath>

namespace promenade::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double degree = M_PI / 180;

Matrix3d about(double degrees, const Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * degree, axis).toRotationMatrix();
}

double nearest_turn(double angle, double previous) {
  return angle - 360 * std::round((angle - previous) / 360);
}

// Degrees about Z, Y, X with R = Rz Ry Rx. Each angle is taken from what the ones before
// leave, so that the product is right near 90 degrees about Y too.
Vector3d zyx_angles(const Matrix3d& rotation) {
  const double z = std::atan2(rotation(1, 0), rotation(0, 0)) / degree;
  const Matrix3d rest = about(-z, Vector3d::UnitZ()) * rotation;
  const double y = std::atan2(-rest(2, 0), rest(0, 0)) / degree;
  const double x = std::atan2(-rest(1, 2), rest(1, 1)) / degree;
  return {z, y, x};
}

// Of the ways to write a rotation, the one nearest to the frame before.
Vector3d zyx_angles(const Matrix3d& rotation, const Vector3d& previous) {
  Vector3d one = zyx_angles(rotation);
  Vector3d other(one.x() + 180, 180 - one.y(), one.z() + 180);
  for (int i = 0; i < 3; ++i) {
    one(i) = nearest_turn(one(i), previous(i));
    other(i) = nearest_turn(other(i), previous(i));
  }
  return (other - previous).squaredNorm() < (one - previous).squaredNorm() ? other : one;
}

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
