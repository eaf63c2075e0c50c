#include "motion/cycle_clip.h"

#include <algorithm>
#include <cmath>

#include "motion/take_clip.h"

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

}  // namespace

Clip cycle_clip(const MotionSet& set, const Cycle& cycle) {
  const int frames = frame_count(cycle);
  Take take{cycle.name, set.skeleton, set.body, cycle.seconds / frames, {}, 0, 0};
  for (int f = 0; f <= frames; ++f) {
    const double seconds = f * take.frame_time;
    // The phase of the closing frame is that of the first, to the last bit.
    Pose pose = pose_at(set, cycle, f == frames ? 0 : phase_at(set, cycle, seconds));
    pose.root += Vector3d(cycle.velocity.x(), 0, cycle.velocity.y()) * seconds;
    take.poses.push_back(std::move(pose));
  }
  return take_clip(take);
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
