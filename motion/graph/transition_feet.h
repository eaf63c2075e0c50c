// When the feet of a transition stand, and how far they slide. Used by the files of transitions
// only. Frames are counted as in transition_blend.h; feet are 0 for the left, 1 for the right.
#pragma once

#include "motion/graph/transition_blend.h"

namespace promenade::motion {

inline constexpr std::array foot_sides = {Side::left, Side::right};

// Frames in which a foot stands, both included.
struct StandingRun {
  int from = 0, to = 0;
};

// A foot stands while the two captures, each with its weight, say that it does: how far they are
// inside of a stance is mixed. So one that leaves a little earlier in B than in A leaves in
// between.
std::vector<StandingRun> standing_runs(const Blend& blend, std::size_t foot);

// Where one foot is, 3 x (k + 1), metres.
struct FootPlaces {
  Eigen::Matrix3Xd ankle, toe;
};
FootPlaces foot_places(const Blend& blend, std::size_t foot);
FootPlaces foot_places(const Blend& blend, std::size_t foot, std::span<const WorldPose> worlds);

// 2 x k, metres (x, z): how its supporting point moves from frame to frame, which is the one of
// heel, ankle and toe that moves least.
Eigen::Matrix2Xd support_steps(const Blend& blend, std::size_t foot, const FootPlaces& places);

// The longest way of the supporting point over one standing run, metres.
double slide_m(const std::vector<StandingRun>& runs, const Eigen::Matrix2Xd& steps);

}  // namespace promenade::motion
