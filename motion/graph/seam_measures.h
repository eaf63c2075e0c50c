// How smooth a motion is from frame to frame: by how much a joint is elsewhere than its own
// motion would have brought it (the second difference of its places), and by how much a knee is
// bent otherwise. A jump in place and one in velocity both show in it. Captures have gaps too,
// the largest where heels strike: a seam is judged beside them, at the same time between frames.
#pragma once

#include <array>
#include <span>

#include "motion/leg_ik.h"
#include "motion/take.h"

namespace promenade::motion {

// Feet in arrays: left, right.
inline constexpr std::array foot_sides = {Side::left, Side::right};

using KneeAxes = std::array<Eigen::Vector3d, 2>;
KneeAxes knee_axes(const Take& take);  // leg_ik.h

struct FrameGap {
  double place_m = 0;  // the largest of any joint
  double knee = 0;     // the larger of both knees, radians
};

// At the frame `now`, from the frames before and after it.
FrameGap frame_gap(const Skeleton& skeleton, const BodyMap& body, const KneeAxes& axes,
                   const WorldPose& before, const WorldPose& now, const WorldPose& after);

// Of all frames (T); the first and the last have none.
std::vector<FrameGap> frame_gaps(const Take& take, const KneeAxes& axes);

// The largest of each; none: zero.
FrameGap largest_gap(std::span<const FrameGap> gaps);

}  // namespace promenade::motion
