#include "motion/take_clip.h"

#include <algorithm>

#include "motion/zyx_angles.h"

namespace promenade::motion {
namespace {

void set_channels(Clip& clip) {
  using enum Channel;
  int row = 0;
  for (int j = 0; j < clip.skeleton.size(); ++j) {
    JointChannels own{{z_rotation, y_rotation, x_rotation}, row};
    if (j == 0) {
      own.channels = {x_position, y_position, z_position, z_rotation, y_rotation, x_rotation};
    }
    row += static_cast<int>(own.channels.size());
    clip.channels.push_back(std::move(own));
  }
}

}  // namespace

Clip take_clip(const Take& take) {
  Clip clip;
  clip.file = take.source;
  clip.format = "bvh";
  clip.skeleton = take.skeleton;
  clip.skeleton.joints[0].offset.setZero();
  clip.unit_m = 1;
  clip.frame_time = take.frame_time;
  set_channels(clip);
  clip.values.resize(3 + 3 * take.skeleton.size(), take.frames());
  for (int f = 0; f < take.frames(); ++f) {
    const Pose& pose = take.poses[static_cast<std::size_t>(f)];
    auto values = clip.values.col(f);
    values.head<3>() = pose.root;
    for (int j = 0; j < take.skeleton.size(); ++j) {
      const Eigen::Matrix3d rotation =
          pose.rotations[static_cast<std::size_t>(j)].normalized().toRotationMatrix();
      const Eigen::Vector3d before = clip.values.col(std::max(f - 1, 0)).segment<3>(3 + 3 * j);
      values.segment<3>(3 + 3 * j) = f == 0 ? zyx_angles(rotation) : zyx_angles(rotation, before);
    }
  }
  return clip;
}

}  // namespace promenade::motion
