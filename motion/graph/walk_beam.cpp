#include "motion/graph/walk_beam.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/graph/cut_graph.h"
#include "motion/graph/index.h"

namespace promenade::motion {
namespace {

class Beam {
 public:
  Beam(const MotionGraph& graph, const WalkObjective& objective, const BeamOptions& options)
      : graph_(graph),
        objective_(objective),
        options_(options),
        ways_(digraph_of(graph)),
        at_node_(graph.nodes.size(), 0) {}

  BeamWalk run(const std::vector<WalkState>& starts, const BeamProgress& progress) {
    for (std::size_t s = 0; s < starts.size(); ++s) {
      add({starts[s], -1, -1 - static_cast<int>(s)});
    }
    for (; level_ < levels_.size() && !stopped_; ++level_) {
      // Short edges do not leave the level: then there is more to choose from. Where somebody
      // stands there might be no end of it.
      const std::size_t most = history_.size() + 4 * at(options_.width);
      while (!levels_[level_].empty() && history_.size() < most) {
        go_on(chosen(std::exchange(levels_[level_], {})));
      }
      levels_[level_] = {};
      if (progress && furthest_ && level_ % 4 == 3) {
        const BeamWalk best = walk_to(*furthest_, starts);
        stopped_ = !best.found.edges.empty() && !progress(best);
      }
    }
    if (done_) return walk_to(*done_, starts);
    return stopped_ && furthest_ ? walk_to(*furthest_, starts) : BeamWalk{};
  }

 private:
  struct Walker {
    WalkState state;
    int parent;  // in history_; -1: it has just begun
    int edge;    // that led here; of a beginning, minus the number of its start, minus 1
    double order = 0;
  };
  struct Past {
    int parent, edge;
  };

  void add(Walker walker) {
    const double level = std::floor(walker.state.travelled_m / options_.level_m);
    const std::size_t where = std::max(level_, static_cast<std::size_t>(std::max(level, 0.0)));
    if (where >= levels_.size()) levels_.resize(where + 1);
    walker.order = walker.state.cost + objective_.outlook(walker.state, options_.outlook);
    levels_[where].push_back(walker);
  }

  // The best of those that wait, not too many at one node.
  std::vector<Walker> chosen(std::vector<Walker> waiting) {
    std::stable_sort(waiting.begin(), waiting.end(),
                     [](const Walker& a, const Walker& b) { return a.order < b.order; });
    std::vector<Walker> best;
    std::ranges::fill(at_node_, 0);
    for (const Walker& walker : waiting) {
      if (static_cast<int>(best.size()) >= options_.width) break;
      if (done_ && walker.state.cost >= done_->state.cost) continue;
      if (at_node_[at(walker.state.node)]++ < options_.at_one_node) best.push_back(walker);
    }
    return best;
  }

  void go_on(const std::vector<Walker>& walkers) {
    if (!walkers.empty()) furthest_ = walkers.front();
    for (const Walker& walker : walkers) {
      const int past = static_cast<int>(history_.size());
      history_.push_back({walker.parent, walker.edge});
      for (const int edge : ways_.leaving(walker.state.node)) {
        const Walker next = step(walker, edge, past);
        next.state.done ? finish(next) : add(next);
      }
    }
  }

  Walker step(const Walker& from, int edge, int past) {
    ++visited_;
    const int frames = graph_.edge(edge).frames;
    return {objective_.after(from.state, edge, frames), past, edge};
  }

  void finish(const Walker& walker) {
    if (!done_ || walker.state.cost < done_->state.cost) done_ = walker;
  }

  BeamWalk walk_to(const Walker& last, const std::vector<WalkState>& starts) const {
    BeamWalk walk;
    walk.found.end = last.state;
    walk.found.visited = visited_;
    walk.found.stopped = stopped_;
    walk.found.complete = false;
    Past past{last.parent, last.edge};
    for (; past.edge >= 0; past = history_[at(past.parent)]) walk.found.edges.push_back(past.edge);
    std::reverse(walk.found.edges.begin(), walk.found.edges.end());
    walk.start = starts[at(-1 - past.edge)];
    return walk;
  }

  const MotionGraph& graph_;
  const WalkObjective& objective_;
  const BeamOptions& options_;
  const Digraph ways_;
  std::vector<std::vector<Walker>> levels_;  // those that wait, by how far they have come
  std::size_t level_ = 0;
  std::vector<Past> history_;  // of all walkers that went on
  std::vector<int> at_node_;   // walkers chosen on this level
  std::optional<Walker> done_, furthest_;
  std::int64_t visited_ = 0;
  bool stopped_ = false;
};

}  // namespace

BeamWalk best_of_many(const MotionGraph& graph, const WalkObjective& objective,
                      const std::vector<WalkState>& starts, const BeamOptions& options,
                      const BeamProgress& progress) {
  return Beam(graph, objective, options).run(starts, progress);
}

}  // namespace promenade::motion
