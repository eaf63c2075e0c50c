// When the feet of a transition stand, and how they move over the ground. Used by the files of
// transitions only. Frames are counted as in transition_blend.h.
#pragma once

#include "motion/graph/transition_blend.h"

namespace promenade::motion {

// Frames in which a foot is down, both included; it lands until it is still. One that does not
// come to rest has still > to.
struct StandingRun {
  int from = 0, still = 0, to = 0;
};
// From before the transition until after it.
inline bool stands_through(const Blend& blend, const StandingRun& run) {
  return run.from == 0 && run.to == blend.last();
}

using FootRuns = std::array<std::vector<StandingRun>, 2>;

// How far inside of a stance it is, or of the time in which it is still: in frames, the two
// captures mixed by their weights.
double standing_depth(const Blend& blend, std::size_t foot, int q,
                      std::vector<double> FootedLeg::*inside);

// A foot is down while that is not negative. So one that leaves a little earlier in B than in A
// leaves in between.
std::vector<StandingRun> standing_runs(const Blend& blend, std::size_t foot);

// k + 1: where heel, ankle and toe are, metres.
std::vector<Ground> foot_ground(const Blend& blend, std::size_t foot);

// 2 x k, metres (x, z): how its supporting point moves from frame to frame, which it should not.
// That is the one that supports it in the capture which counts more: where B lies does not change
// it. Of a foot that lands, what it moves beside what it does in the captures.
Eigen::Matrix2Xd support_steps(const Blend& blend, std::size_t foot,
                               const std::vector<StandingRun>& runs,
                               const std::vector<Ground>& ground);

// The longest way of the point that moves least, over the frames of one run in which the foot is
// still, metres.
double slide_m(const std::vector<StandingRun>& runs, const std::vector<Ground>& ground);

}  // namespace promenade::motion
