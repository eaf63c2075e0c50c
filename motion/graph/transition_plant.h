// Makes the feet of a transition stand. Used by transition.cpp only.
#pragma once

#include "motion/graph/transition_feet.h"

namespace promenade::motion {

// Moves feet over the ground, and the pelvis with them, so that those that stand stay where they
// are; what was moved fades while they swing. Feet keep their directions, and the frames before
// and after the transition stay as they are. Returns the most that an ankle was moved, metres.
double plant_feet(Blend& blend, const FootRuns& runs);

}  // namespace promenade::motion
