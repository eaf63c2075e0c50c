// Walks over a motion graph that follow no path: by lot, and through styles one after the other,
// as stimuli that change style without a cut. The same seed gives the same walk anywhere.
#pragma once

#include "motion/graph/motion_graph.h"

namespace promenade::motion {

// Edges, from any node on, of at least so many frames. What was walked less often is more likely
// to come next, so that a walk does not circle in one loop and sees all of the graph in time.
std::vector<int> random_walk(const MotionGraph& graph, std::uint64_t seed, int frames);

struct WantedLabel {
  std::string label;
  double seconds = 0;
};

struct LabelWalk {
  std::vector<int> edges;
  int other_label = 0;  // frames with a label that is not the one wanted: passages
};

// Shows each label for about its seconds, one after the other, with as few frames of other labels
// as can be: it leaves a label within a quarter of its seconds from where it should (ours), where
// the passage to the next is shortest. Of many walks by lot the best is taken: the fewest frames
// of other labels and beside the wanted seconds, then the transitions that are the most alike.
// Throws an InputError where no edge has a label.
LabelWalk walk_through_labels(const MotionGraph& graph, const std::vector<WantedLabel>& wanted,
                              std::uint64_t seed);

}  // namespace promenade::motion
