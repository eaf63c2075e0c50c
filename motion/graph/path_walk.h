// A walk over a motion graph that follows a path over the ground ([K] 5.2): the one whose way
// differs least from the path. Frame by frame, the place of the pelvis is compared with the point
// of the path that is as many metres from its beginning as somebody has walked by then
// (edge_ways.h), squared, and summed.
//
// Two searches are made, and the cheaper walk is taken: many walks side by side over the whole
// path (walk_beam.h, ours), which prepares a turn in time and decides where to begin; and from that
// beginning horizon by horizon as in [K] (walk_search.h), which can prove that within each
// horizon nothing is better.
#pragma once

#include "motion/graph/edge_ways.h"
#include "motion/graph/ground_path.h"
#include "motion/graph/walk_search.h"

namespace promenade::motion {

// A style that is wanted on a part of the path.
struct PathPart {
  double from_m = 0, to_m = 0;  // of the path
  std::string label;
};

struct PathWalkOptions {
  std::vector<PathPart> parts;  // they do not overlap
  std::string start_label;      // empty: that of the part at 0 m, or any
  // A frame of another label than its part wants costs as if it were so far off the path (ours):
  // so there is always a walk, and short passages through other styles are accepted.
  double other_label_m = 1;
  double horizon_s = 4, kept_s = 1;
  std::int64_t most_edges = 50'000;  // visited in a horizon
};

struct PathWalk {
  GraphWalk walk;  // in the world of the path
  int frames = 0;  // until as far is walked as the path is long; the last edge may go on
  double walked_m = 0;
  double cost_m2 = 0;                // sum of squares over these frames
  double rms_m = 0, farthest_m = 0;  // from the wanted points
  int other_label = 0;               // frames that do not have the label of their part
  bool complete = true;  // no other walk is better within any horizon: each was searched to its end
  bool stopped = false;  // by `progress`: the best until then, which may end before the path does
  std::int64_t visited = 0;
};

// Told of the best walk so far, and of the share of the work that is done, 0 to 1; false stops.
using PathProgress = std::function<bool(const GraphWalk&, double)>;

// Throws an InputError where no edge has a label that is asked for.
PathWalk walk_along(const MotionGraph& graph, const GroundPath& path,
                    const PathWalkOptions& options = {}, const PathProgress& progress = {});

// The same with ways that are there already, as many paths over one graph need.
PathWalk walk_along(const MotionGraph& graph, const std::vector<EdgeWay>& ways,
                    const GroundPath& path, const PathWalkOptions& options,
                    const PathProgress& progress = {});

}  // namespace promenade::motion
