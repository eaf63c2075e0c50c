// One loop out of a take: straightened, turned to walk along +Z, and closed so
// that neither position nor velocity jumps at the seam.
#pragma once

#include "motion/cycle_search.h"
#include "motion/motion_set.h"

namespace promenade::motion {

// The set gives skeleton, phases and key phases; the take's joints are those of the
// set's skeleton in the same order. What the last pose misses of the first is spread
// over the whole cycle, what the velocity misses over the moments beside the seam.
// Names are not filled in.
Cycle cut_cycle(const MotionSet& set, const Take& take, const CycleCandidate& candidate);

}  // namespace promenade::motion
