// Where a take comes back to what it did before: the best places to cut a cycle out of it. Any
// motion has them, walks and others.
#pragma once

#include "motion/graph/matches.h"

namespace promenade::motion {

struct LoopOptions {
  double shortest_s = 0.5, longest_s = 4;  // from the start of one window to that of the other
  double threshold_m = 0.06;               // RMS of the points, weighed as in clouds.h
  double window_s = 1.0 / 3;
  bool tapered = false;
};

// The local minima of the take's own distance map that are so far apart, the best first: the
// frames start_a .. start_b are a cycle. Several cycles in a row are among them, where they
// are not too long. Both takes of a match are 0.
std::vector<Match> find_loops(const Take& take, const LoopOptions& options = {});

}  // namespace promenade::motion
