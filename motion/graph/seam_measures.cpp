#include "motion/graph/seam_measures.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace promenade::motion {

KneeAxes knee_axes(const Take& take) {
  KneeAxes axes;
  for (std::size_t s = 0; s < foot_sides.size(); ++s) {
    axes[s] = knee_axis(take.skeleton, take.body, foot_sides[s], take.poses);
  }
  return axes;
}

FrameGap frame_gap(const Skeleton& skeleton, const BodyMap& body, const KneeAxes& axes,
                   const WorldPose& before, const WorldPose& now, const WorldPose& after) {
  FrameGap gap;
  gap.place_m =
      (before.positions - 2 * now.positions + after.positions).colwise().norm().maxCoeff();
  for (std::size_t s = 0; s < foot_sides.size(); ++s) {
    const auto bend = [&](const WorldPose& world) {
      return knee_bend(skeleton, body, foot_sides[s], axes[s], world);
    };
    gap.knee = std::max(gap.knee, std::abs(bend(before) - 2 * bend(now) + bend(after)));
  }
  return gap;
}

std::vector<FrameGap> frame_gaps(const Take& take, const KneeAxes& axes) {
  std::vector<FrameGap> gaps(take.poses.size());
  if (gaps.size() < 3) return gaps;
  WorldPose before = forward_kinematics(take.skeleton, take.poses[0]);
  WorldPose now = forward_kinematics(take.skeleton, take.poses[1]);
  WorldPose after = now;
  for (std::size_t f = 1; f + 1 < gaps.size(); ++f) {
    forward_kinematics(take.skeleton, take.poses[f + 1], after);
    gaps[f] = frame_gap(take.skeleton, take.body, axes, before, now, after);
    std::swap(before, now);
    std::swap(now, after);
  }
  return gaps;
}

FrameGap largest_gap(std::span<const FrameGap> gaps) {
  FrameGap largest;
  for (const FrameGap& gap : gaps) {
    largest.place_m = std::max(largest.place_m, gap.place_m);
    largest.knee = std::max(largest.knee, gap.knee);
  }
  return largest;
}

}  // namespace promenade::motion
