// The takes of a motion graph: captures, brought onto one skeleton, one floor and one frame
// rate, or the cycles of a motion set, each walked a few times.
#pragma once

#include <functional>

#include "motion/graph/motion_graph.h"
#include "motion/motion_set.h"
#include "motion/take_source.h"

namespace promenade::motion {

struct GraphTakeOptions {
  ReadOptions read;
  std::optional<double> rate;  // frames a second, for all; else that of the takes, which agree
};

struct GraphTakes {
  std::vector<GraphTake> takes;  // in the order of their labels and files
  std::vector<Problem> warnings;
};

// T-poses before a motion are left out. `progress` is called before each take is read. Throws
// InputError with all problems of all files: what cannot be read, other joints, other rates.
GraphTakes load_graph_takes(std::vector<TakeSource> sources, const GraphTakeOptions& options,
                            const std::function<void(const TakeSource&)>& progress = {});

// Every cycle so many times in a row, walking along +Z; its label is its style.
std::vector<GraphTake> takes_of_set(const MotionSet& set, double rate, int times = 3);

}  // namespace promenade::motion
