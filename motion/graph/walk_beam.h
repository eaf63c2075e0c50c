// A good walk over a motion graph, looked for in all its length at once: many walks side by side,
// of which only the best of those that have come as far go on (a beam search, ours). It proves
// nothing, but where a figure has to prepare a turn long before it comes, the short horizons of
// walk_search.h see too little.
#pragma once

#include "motion/graph/walk_search.h"

namespace promenade::motion {

struct BeamOptions {
  double level_m = 0.1;  // walks are compared when they have travelled as far, to so much
  int width = 4000;      // walks that go on from each level
  int at_one_node = 3;   // of these, so many at most at the same node, so that they differ
  int outlook = 0;       // frames: how far the objective is to look ahead
};

struct BeamWalk {
  WalkState start;
  FoundWalk found;  // no edges: no walk was done; `complete` is false
};

// Told of the best walk so far now and then; false stops the search.
using BeamProgress = std::function<bool(const BeamWalk&)>;

// The best walk that is done, from any of the starts. Memory: a few numbers for each walk of each
// level. Stopped, it gives the walk that had come furthest, and of these the cheapest.
BeamWalk best_of_many(const MotionGraph& graph, const WalkObjective& objective,
                      const std::vector<WalkState>& starts, const BeamOptions& options,
                      const BeamProgress& progress = {});

}  // namespace promenade::motion
