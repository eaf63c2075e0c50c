#include "motion/graph/path_walk.h"

#include <algorithm>
#include <cmath>

#include "motion/graph/path_objective.h"
#include "motion/problem.h"

namespace promenade::motion {
namespace {

using PathProgress = std::function<bool(const GraphWalk&, double)>;

std::size_t at(int index) { return static_cast<std::size_t>(index); }

WalkSearchOptions search_options(const MotionGraph& graph, const PathWalkOptions& options) {
  WalkSearchOptions search;
  search.horizon = std::max(1, static_cast<int>(std::lround(options.horizon_s / graph.frame_time)));
  search.kept = std::max(1, static_cast<int>(std::lround(options.kept_s / graph.frame_time)));
  search.most_edges = options.most_edges;
  return search;
}

// The label that somebody begins with; empty: any.
std::string first_label(const PathWalkOptions& options) {
  if (!options.start_label.empty()) return options.start_label;
  for (const PathPart& part : options.parts) {
    if (part.from_m <= 0 && part.to_m > 0) return part.label;
  }
  return {};
}

struct Begun {
  WalkState state;
  FoundWalk walk;  // of the first horizon
};

// Searches the first horizon of every start: first the one walk that looks best at each node, then,
// where that was cheapest, a little around it. `goes_on` is asked now and then.
class StartSearch {
 public:
  StartSearch(const WalkSearch& search, WalkSearchOptions options,
              const std::function<bool()>& goes_on)
      : search_(search), options_(options), goes_on_(goes_on) {}

  Begun best(const std::vector<WalkState>& states) {
    for (const WalkState& state : states) {
      if (begun_.empty() || goes_on_()) dive(state);
    }
    std::stable_sort(begun_.begin(), begun_.end(), [](const Begun& a, const Begun& b) {
      return a.walk.end.cost < b.walk.end.cost;
    });
    Begun best = begun_.front();
    options_.most_edges = std::max<std::int64_t>(1, options_.most_edges / 64);
    for (std::size_t i = 0; i < std::min<std::size_t>(64, begun_.size()) && goes_on_(); ++i) {
      look_around(begun_[i], best);
    }
    best.walk.visited = visited_;
    return best;
  }

 private:
  void dive(const WalkState& state) {
    WalkSearchOptions one = options_;
    one.most_edges = 1;
    FoundWalk walk = search_.within_horizon({state}, one);
    visited_ += walk.visited;
    if (!walk.edges.empty()) begun_.push_back({state, std::move(walk)});
  }

  void look_around(const Begun& from, Begun& best) {
    FoundWalk walk = search_.within_horizon({from.state, {}, best.walk.end.cost}, options_,
                                            [this](const FoundWalk&) { return goes_on_(); });
    visited_ += walk.visited;
    if (!walk.edges.empty()) best = {from.state, std::move(walk)};
  }

  const WalkSearch& search_;
  WalkSearchOptions options_;
  const std::function<bool()>& goes_on_;
  std::vector<Begun> begun_;
  std::int64_t visited_ = 0;
};

// What a walk came to, frame by frame.
void measure(const MotionGraph& graph, const PathObjective& objective, WalkState state,
             PathWalk& walk) {
  double sum = 0;
  for (const int edge : walk.walk.edges) {
    const int frames = objective.counted(state, edge, graph.edges[at(edge)].frames);
    for (int i = 0; i < frames; ++i) {
      const double off = objective.distance(state, edge, i);
      sum += off * off;
      walk.farthest_m = std::max(walk.farthest_m, off);
    }
    walk.other_label += objective.other_label(state, edge, frames);
    state = objective.after(state, edge, graph.edges[at(edge)].frames);
  }
  walk.frames = state.frames;
  walk.walked_m = state.travelled_m;
  walk.cost_m2 = sum;
  walk.rms_m = walk.frames > 0 ? std::sqrt(sum / walk.frames) : 0;
}

void require_labels(const MotionGraph& graph, const PathWalkOptions& options) {
  if (!options.start_label.empty()) require_label(graph, options.start_label);
  for (const PathPart& part : options.parts) require_label(graph, part.label);
}

std::vector<WalkState> starts_of(const MotionGraph& graph, const PathObjective& objective,
                                 const PathWalkOptions& options) {
  std::vector<WalkState> starts = objective.starts(first_label(options));
  if (starts.empty()) starts = objective.starts({});
  if (starts.empty()) throw InputError(graph.name, "has no place at which somebody moves on");
  return starts;
}

}  // namespace

PathWalk walk_along(const MotionGraph& graph, const std::vector<EdgeWay>& ways,
                    const GroundPath& path, const PathWalkOptions& options,
                    const PathProgress& progress) {
  require_labels(graph, options);
  const PathObjective objective(graph, ways, path, options);
  const WalkSearch search(graph, objective);
  const WalkSearchOptions how = search_options(graph, options);
  const std::function<bool()> goes_on = [&] { return !progress || progress({}, 0); };
  const Begun begun = StartSearch(search, how, goes_on).best(starts_of(graph, objective, options));
  const auto heard = [&](const FoundWalk& found) {
    return progress({found.edges, begun.state.place},
                    std::min(1.0, found.end.travelled_m / path.length()));
  };
  const FoundWalk found = search.whole_walk({begun.state, begun.walk.edges}, how,
                                            progress ? WalkProgress(heard) : WalkProgress());
  PathWalk walk;
  walk.walk = {found.edges, begun.state.place};
  walk.complete = found.complete;
  walk.stopped = found.stopped;
  walk.visited = found.visited + begun.walk.visited;
  measure(graph, objective, begun.state, walk);
  return walk;
}

PathWalk walk_along(const MotionGraph& graph, const GroundPath& path,
                    const PathWalkOptions& options, const PathProgress& progress) {
  return walk_along(graph, edge_ways(graph, edge_courses(graph)), path, options, progress);
}

}  // namespace promenade::motion
