#include "motion/cycle_clip.h"

#include <algorithm>
#include <cmath>

#include "motion/zyx_angles.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

// At the most as many as ten seconds have at a thousand a second: what a damaged file says
// must not fill the disk.
constexpr int most_frames = 10'000;

int frame_count(const Cycle& cycle) {
  const double made = std::min(std::round(60 * cycle.seconds), double{most_frames});
  return std::clamp(cycle.frames > 0 ? cycle.frames : static_cast<int>(made), 2, most_frames);
}

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

Clip cycle_clip(const MotionSet& set, const Cycle& cycle) {
  Clip clip;
  clip.file = cycle.name;
  clip.format = "bvh";
  clip.skeleton = set.skeleton;
  clip.skeleton.joints[0].offset.setZero();
  clip.unit_m = 1;
  const int frames = frame_count(cycle);
  clip.frame_time = cycle.seconds / frames;
  set_channels(clip);
  clip.values.resize(3 + 3 * set.skeleton.size(), frames + 1);
  for (int f = 0; f <= frames; ++f) {
    const double seconds = f * clip.frame_time;
    // The phase of the closing frame is that of the first, to the last bit.
    const Pose pose = pose_at(set, cycle, f == frames ? 0 : phase_at(set, cycle, seconds));
    auto values = clip.values.col(f);
    values.head<3>() = pose.root + Vector3d(cycle.velocity.x(), 0, cycle.velocity.y()) * seconds;
    for (int j = 0; j < set.skeleton.size(); ++j) {
      const Eigen::Matrix3d rotation =
          pose.rotations[static_cast<std::size_t>(j)].normalized().toRotationMatrix();
      const Vector3d before = clip.values.col(std::max(f - 1, 0)).segment<3>(3 + 3 * j);
      values.segment<3>(3 + 3 * j) = f == 0 ? zyx_angles(rotation) : zyx_angles(rotation, before);
    }
  }
  return clip;
}

Clip repeated_clip(Clip clip, int times) {
  const Eigen::MatrixXd one = std::move(clip.values);
  const Eigen::Index frames = one.cols() - 1;
  const Vector3d travel = one.col(frames).head<3>() - one.col(0).head<3>();
  clip.values.resize(one.rows(), times * frames + 1);
  for (Eigen::Index f = 0; f < clip.values.cols(); ++f) {
    clip.values.col(f) = one.col(f % frames);
    clip.values.col(f).head<3>() += static_cast<double>(f / frames) * travel;
  }
  return clip;
}

}  // namespace promenade::motion
