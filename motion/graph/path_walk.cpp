#include "motion/graph/path_walk.h"

#include <algorithm>
#include <cmath>

#include "motion/graph/graph_labels.h"
#include "motion/graph/path_objective.h"
#include "motion/graph/walk_beam.h"
#include "motion/problem.h"

namespace promenade::motion {
namespace {

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

// What a walk came to, frame by frame.
void measure(const MotionGraph& graph, const PathObjective& objective, WalkState state,
             PathWalk& walk) {
  double sum = 0;
  for (const int edge : walk.walk.edges) {
    const int frames = objective.counted(state, edge, graph.edge(edge).frames);
    for (int i = 0; i < frames; ++i) {
      const double off = objective.distance(state, edge, i);
      sum += off * off;
      walk.farthest_m = std::max(walk.farthest_m, off);
    }
    walk.other_label += objective.other_label(state, edge, frames);
    state = objective.after(state, edge, graph.edge(edge).frames);
  }
  walk.frames = state.frames;
  walk.walked_m = state.travelled_m;
  walk.cost_m2 = sum;
  walk.rms_m = walk.frames > 0 ? std::sqrt(sum / walk.frames) : 0;
}

PathWalk measured(const MotionGraph& graph, const PathObjective& objective, const BeamWalk& from) {
  PathWalk walk;
  walk.walk = {from.found.edges, from.start.place};
  walk.complete = from.found.complete;
  walk.stopped = from.found.stopped;
  walk.visited = from.found.visited;
  measure(graph, objective, from.start, walk);
  return walk;
}

// The search has three parts, of which each takes about as long.
double done_after(int parts, double share) { return (parts + share) / 3; }

BeamProgress telling_beam(const GroundPath& path, const PathProgress& progress) {
  if (!progress) return {};
  return [&path, &progress](const BeamWalk& best) {
    const double share = std::min(1.0, best.found.end.travelled_m / path.length());
    return progress({best.found.edges, best.start.place}, done_after(0, share));
  };
}

// While something is looked for that is better than `best`.
BeamProgress telling_beside(const BeamWalk& best, int parts, const GroundPath& path,
                            const PathProgress& progress) {
  if (!progress) return {};
  return [&best, &path, &progress, parts](const BeamWalk& other) {
    const double share = std::min(1.0, other.found.end.travelled_m / path.length());
    return progress({best.found.edges, best.start.place}, done_after(parts, share));
  };
}

// Where captures turn often, many walks near the best find the best. Where they turn seldom,
// those that turn look bad for long: then the best at each node must all go on.
BeamWalk look_broadly(const MotionGraph& graph, const PathObjective& objective,
                      const std::vector<WalkState>& starts, const GroundPath& path,
                      const PathProgress& progress) {
  const int outlook = static_cast<int>(std::lround(0.1 / graph.frame_time));
  const BeamOptions near{0.1, 1000, 6, outlook}, everywhere{0.1, 5000, 1, outlook};
  BeamWalk best = best_of_many(graph, objective, starts, near, telling_beam(path, progress));
  if (best.found.stopped) return best;
  BeamWalk other =
      best_of_many(graph, objective, starts, everywhere, telling_beside(best, 1, path, progress));
  const std::int64_t visited = best.found.visited + other.found.visited;
  const bool better = !other.found.stopped && !other.found.edges.empty() &&
                      other.found.end.cost < best.found.end.cost;
  if (better || best.found.edges.empty()) best = std::move(other);
  best.found.visited = visited;
  return best;
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
  const BeamWalk broad =
      look_broadly(graph, objective, starts_of(graph, objective, options), path, progress);
  if (broad.found.stopped || broad.found.edges.empty()) return measured(graph, objective, broad);
  // Whatever costs more already need not be searched to its end.
  const BeamProgress told = telling_beside(broad, 2, path, progress);
  const auto still_better = [&](const FoundWalk& found) {
    return found.end.cost <= broad.found.end.cost && (!told || told({broad.start, found}));
  };
  const BeamWalk deep{broad.start,
                      search.whole_walk({broad.start, broad.found.edges}, how, still_better)};
  const bool better = deep.found.end.done && deep.found.end.cost <= broad.found.end.cost;
  PathWalk walk = measured(graph, objective, better ? deep : broad);
  walk.complete = deep.found.complete && better;
  walk.visited = deep.found.visited + broad.found.visited;
  return walk;
}

PathWalk walk_along(const MotionGraph& graph, const GroundPath& path,
                    const PathWalkOptions& options, const PathProgress& progress) {
  return walk_along(graph, edge_ways(graph, edge_courses(graph)), path, options, progress);
}

}  // namespace promenade::motion
