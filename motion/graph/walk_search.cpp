#include "motion/graph/walk_search.h"

#include <algorithm>

#include "motion/graph/cut_graph.h"

namespace promenade::motion {
namespace {

// One search within one horizon.
class HorizonSearch {
 public:
  HorizonSearch(const MotionGraph& graph, const Digraph& ways, const WalkObjective& objective,
                const HorizonStart& start, const WalkSearchOptions& options)
      : graph_(graph),
        ways_(ways),
        objective_(objective),
        options_(options),
        start_(start),
        last_frame_(start.state.frames + options.horizon),
        bound_(start.below) {}

  FoundWalk run(const WalkProgress& progress) {
    follow(start_.hint);
    expand(start_.state);
    while (!steps_.empty() && !spent() && !best_.stopped) {
      if (!go_on()) leave();
      if (progress && visited_ >= next_report_) report(progress);
    }
    best_.complete = nothing_left();
    best_.visited = visited_;
    return std::move(best_);
  }

 private:
  struct Choice {
    double order;  // the smallest is tried first
    int edge;
    WalkState state;  // behind it
  };
  struct Step {  // choices first .. size of choices_; the ones behind the last step's are its own
    std::size_t first, next;
  };

  bool at_the_end(const WalkState& state) const {
    return state.done || state.frames >= last_frame_;
  }
  void report(const WalkProgress& progress) {
    next_report_ = visited_ + 100'000;
    best_.visited = visited_;
    best_.stopped = !progress(best_);
  }
  bool spent() const {
    return visited_ >= options_.most_edges && bound_ < std::numeric_limits<double>::infinity();
  }

  // Whether no choice that was left out could lead to anything better.
  bool nothing_left() const {
    std::size_t last = choices_.size();
    for (std::size_t s = steps_.size(); s-- > 0; last = steps_[s].first) {
      for (std::size_t c = steps_[s].next; c < last; ++c) {
        if (choices_[c].state.cost < bound_) return false;
      }
    }
    return true;
  }

  WalkState after(const WalkState& state, int edge) {
    ++visited_;
    const int left = last_frame_ - state.frames;
    return objective_.after(state, edge, std::min(graph_.edge(edge).frames, left));
  }

  void take(const WalkState& end) {
    if (end.cost >= bound_) return;
    bound_ = end.cost;
    best_.edges = edges_;
    best_.end = end;
  }

  // Edges known to be good give a first bound.
  void follow(std::span<const int> hint) {
    WalkState state = start_.state;
    for (const int edge : hint) {
      if (at_the_end(state)) break;
      edges_.push_back(edge);
      state = after(state, edge);
    }
    if (!edges_.empty()) finish(state);
    edges_.clear();
  }

  // On to the horizon, by what looks best at each node.
  void finish(WalkState state) {
    while (!at_the_end(state)) {
      choices_.clear();
      add_choices(state);
      if (choices_.empty()) return;
      state = choices_.front().state;
      edges_.push_back(choices_.front().edge);
    }
    choices_.clear();
    take(state);
  }

  // What can follow and may still be better than the best, in order.
  void add_choices(const WalkState& state) {
    const auto first = static_cast<std::ptrdiff_t>(choices_.size());
    for (const int edge : ways_.leaving(state.node)) {
      const WalkState next = after(state, edge);
      if (next.cost >= bound_) continue;
      const int left = last_frame_ - next.frames;
      const double outlook = left > 0 && !next.done ? objective_.outlook(next, left) : 0;
      choices_.push_back({next.cost + outlook, edge, next});
    }
    std::stable_sort(choices_.begin() + first, choices_.end(),
                     [](const Choice& a, const Choice& b) { return a.order < b.order; });
  }

  void expand(const WalkState& state) {
    const std::size_t first = choices_.size();
    add_choices(state);
    steps_.push_back({first, first});
  }

  // Takes the next choice of the last step. False: none is left.
  bool go_on() {
    Step& step = steps_.back();
    if (step.next == choices_.size()) return false;
    const Choice choice = choices_[step.next++];
    if (choice.state.cost >= bound_) return true;  // a better walk was found meanwhile
    edges_.push_back(choice.edge);
    if (at_the_end(choice.state)) {
      take(choice.state);
      edges_.pop_back();
    } else {
      expand(choice.state);
    }
    return true;
  }

  void leave() {
    choices_.resize(steps_.back().first, {0, 0, {}});
    steps_.pop_back();
    if (!edges_.empty()) edges_.pop_back();
  }

  const MotionGraph& graph_;
  const Digraph& ways_;
  const WalkObjective& objective_;
  const WalkSearchOptions& options_;
  const HorizonStart& start_;
  const int last_frame_;
  double bound_;  // cost of the best; what is not below is of no use
  FoundWalk best_;
  std::int64_t visited_ = 0, next_report_ = 100'000;
  std::vector<int> edges_;  // from the start to the last step
  std::vector<Step> steps_;
  std::vector<Choice> choices_;  // of all steps, one behind the other
};

// A long walk, horizon by horizon.
class LongWalk {
 public:
  LongWalk(const MotionGraph& graph, const WalkObjective& objective, const WalkSearch& search,
           const WalkSearchOptions& options)
      : graph_(graph), objective_(objective), search_(search), options_(options) {}

  FoundWalk run(const HorizonStart& start, const WalkProgress& progress) {
    walk_.end = start.state;
    ahead_.assign(start.hint.begin(), start.hint.end());
    const auto heard = [&](const FoundWalk& found) { return progress(with(found)); };
    while (!walk_.end.done && walk_.end.frames < options_.most_frames) {
      const FoundWalk found = search_.within_horizon(
          {walk_.end, ahead_}, options_, progress ? WalkProgress(heard) : WalkProgress());
      if (found.edges.empty()) break;
      if (found.stopped || (progress && !heard(found))) return stopped(found);
      keep(found);
    }
    return std::move(walk_);
  }

 private:
  // Keeps the first edges; with the others the next search begins.
  void keep(const FoundWalk& found) {
    const int last = walk_.end.frames + options_.kept;
    const bool all = found.end.done && found.complete;
    std::size_t count = 0;
    while (count < found.edges.size() && !walk_.end.done && (all || walk_.end.frames < last)) {
      const int edge = found.edges[count++];
      walk_.end = objective_.after(walk_.end, edge, graph_.edge(edge).frames);
      walk_.edges.push_back(edge);
    }
    ahead_.assign(found.edges.begin() + static_cast<std::ptrdiff_t>(count), found.edges.end());
    walk_.complete = walk_.complete && found.complete;
    walk_.visited += found.visited;
  }

  FoundWalk with(const FoundWalk& found) const {
    FoundWalk all = walk_;
    all.edges.insert(all.edges.end(), found.edges.begin(), found.edges.end());
    if (!found.edges.empty()) all.end = found.end;
    all.complete = all.complete && found.complete;
    all.visited += found.visited;
    return all;
  }

  FoundWalk stopped(const FoundWalk& found) const {
    FoundWalk all = with(found);
    all.complete = false;
    all.stopped = true;
    return all;
  }

  const MotionGraph& graph_;
  const WalkObjective& objective_;
  const WalkSearch& search_;
  const WalkSearchOptions& options_;
  FoundWalk walk_;
  std::vector<int> ahead_;
};

}  // namespace

WalkSearch::WalkSearch(const MotionGraph& graph, const WalkObjective& objective)
    : graph_(graph), objective_(objective), ways_(digraph_of(graph)) {}

FoundWalk WalkSearch::within_horizon(const HorizonStart& start, const WalkSearchOptions& options,
                                     const WalkProgress& progress) const {
  return HorizonSearch(graph_, ways_, objective_, start, options).run(progress);
}

FoundWalk WalkSearch::whole_walk(const HorizonStart& start, const WalkSearchOptions& options,
                                 const WalkProgress& progress) const {
  return LongWalk(graph_, objective_, *this, options).run(start, progress);
}

}  // namespace promenade::motion
