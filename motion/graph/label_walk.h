// Walks over a motion graph that follow no path: by lot, and through styles one after the other,
// as stimuli that change style without a cut. The same seed gives the same walk anywhere.
#pragma once

#include "motion/graph/motion_graph.h"

namespace promenade::motion {

// Edges, from any node on, of at least so many frames. Of the edges that lead on, one that was
// walked least, so that a walk does not circle in one loop and sees all of the graph in time.
std::vector<int> random_walk(const MotionGraph& graph, std::uint64_t seed, int frames);

struct WantedLabel {
  std::string label;
  double seconds = 0;
};

struct LabelWalk {
  std::vector<int> edges;
  int other_label = 0;  // frames with another label than the one wanted then
};

// Shows each label for its seconds, one after the other, with as few frames of other labels than
// the one wanted then as can be: of all walks over the graph, by dynamic programming over its
// nodes and frames, 20 s at a time, less in graphs of many nodes (ours). Of walks that are equal in
// that, the one with the fewest and most alike transitions, but for a little luck, by the seed.
// Throws an InputError where no edge has a label.
LabelWalk walk_through_labels(const MotionGraph& graph, const std::vector<WantedLabel>& wanted,
                              std::uint64_t seed);

}  // namespace promenade::motion
