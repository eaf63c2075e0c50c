// The walk over a motion graph that costs least ([K] 5): branch and bound, depth first. What a
// walk is to be like is said by a WalkObjective; path_walk.h has the one for following a path.
//
// A horizon is so many frames. Within it the search is exact: no walk of the graph costs less, and
// `complete` says that nothing was left out. A long walk is made of many horizons: of the best
// walk within each the first part is kept, and the search goes on from there. So time grows
// with the length of the walk, and memory but by the edges kept.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

#include "motion/graph/digraph.h"
#include "motion/graph/motion_graph.h"

namespace promenade::motion {

// Where somebody is after some edges of a walk.
struct WalkState {
  int node = 0;
  PlanarMove place;        // where the take of the node lies in the world
  int frames = 0;          // since the walk began
  double travelled_m = 0;  // what this is, the objective decides
  double cost = 0;         // of all frames so far: what the search makes small
  bool done = false;       // the walk need not go on
};

class WalkObjective {
 public:
  virtual ~WalkObjective() = default;

  // The state after the first `frames` frames (1 to all) of an edge that leaves the state's
  // node. The cost never falls. A state that is done may count fewer frames.
  virtual WalkState after(const WalkState& state, int edge, int frames) const = 0;
  // What the next `frames` frames may cost: a guess, which decides in which order edges are
  // tried and nothing else.
  virtual double outlook(const WalkState&, int /*frames*/) const { return 0; }
};

struct WalkSearchOptions {
  int horizon = 0;                    // frames, at least 1
  int kept = 0;                       // of these, rounded up to whole edges; at least 1
  std::int64_t most_edges = 100'000;  // visited in a horizon: then the best so far is taken
  int most_frames = 1'000'000;        // of the whole walk
};

struct FoundWalk {
  std::vector<int> edges;
  WalkState end;             // the last edge may reach beyond it: end.frames says how far it counts
  bool complete = true;      // nothing costs less within the horizon (or: within each)
  bool stopped = false;      // by `progress`
  std::int64_t visited = 0;  // edges looked at
};

// Told of the best walk so far, several times a second; false stops the search.
using WalkProgress = std::function<bool(const FoundWalk&)>;

// Where a search within one horizon begins.
struct HorizonStart {
  WalkState state;
  std::span<const int> hint = {};  // edges of a good walk, with which to begin
  double below = std::numeric_limits<double>::infinity();  // a walk that costs more is no answer
};

class WalkSearch {
 public:
  // Both are kept as references. Each node that can be reached has an edge that leaves it, as in
  // every graph of build_graph(); a walk that cannot go on is no answer.
  WalkSearch(const MotionGraph& graph, const WalkObjective& objective);

  // The best walk of `horizon` frames, or to where it is done; no edges: there is none. The search
  // goes on beyond most_edges until it has an answer, unless `below` was given.
  FoundWalk within_horizon(const HorizonStart& start, const WalkSearchOptions& options,
                           const WalkProgress& progress = {}) const;

  // A walk that goes on until it is done (or has most_frames, or has nowhere to go). `below` of
  // the start is not looked at.
  FoundWalk whole_walk(const HorizonStart& start, const WalkSearchOptions& options,
                       const WalkProgress& progress = {}) const;

 private:
  const MotionGraph& graph_;
  const WalkObjective& objective_;
  Digraph ways_;
};

}  // namespace promenade::motion
