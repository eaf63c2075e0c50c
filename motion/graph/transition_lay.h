// Where the capture that is entered lies. Used by transition.cpp only.
#pragma once

#include "motion/graph/transition_feet.h"

namespace promenade::motion {

// Lays B so that the feet that stand need moving least (ours), from where the match has laid it.
// A foot that stands from before the transition until after it fixes B: it cannot be moved at
// either end. Two such feet turn it as well.
void lay_by_feet(Blend& blend, const FootRuns& runs);

}  // namespace promenade::motion
