#include "motion/graph/digraph.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "motion/graph/index.h"

namespace promenade::motion {
namespace {

// Components by depth-first search. `mark_` is 0 for a node not met yet; then the number of the
// earliest open node that it is known to reach; at last last_mark minus its component, which is
// above every number of an open node, so that arcs into what is done change nothing.
class ComponentSearch {
 public:
  explicit ComponentSearch(const Digraph& graph) : graph_(graph), mark_(at(graph.nodes()), 0) {}

  std::vector<int> run() {
    for (int node = 0; node < graph_.nodes(); ++node) {
      if (mark_[at(node)] == 0) visit(node);
    }
    for (int& mark : mark_) mark = last_mark - mark;
    return std::move(mark_);
  }

 private:
  static constexpr int last_mark = std::numeric_limits<int>::max();

  struct Step {  // a node on the way from where the search began
    int node, number;
    std::span<const int> ahead;  // where the arcs lead that were not followed yet
  };

  void enter(int node) {
    mark_[at(node)] = ++met_;
    way_.push_back({node, met_, graph_.heads(node)});
  }

  void visit(int start) {
    enter(start);
    while (!way_.empty()) {
      if (!go_on()) leave();
    }
  }

  // Follows arcs of the last node until one leads to a new node. False: none does.
  bool go_on() {
    Step& step = way_.back();
    int reached = mark_[at(step.node)];
    for (std::size_t i = 0; i < step.ahead.size(); ++i) {
      const int mark = mark_[at(step.ahead[i])];
      if (mark == 0) {
        mark_[at(step.node)] = reached;
        const int next = step.ahead[i];
        step.ahead = step.ahead.subspan(i + 1);
        enter(next);
        return true;
      }
      reached = std::min(reached, mark);
    }
    mark_[at(step.node)] = reached;
    return false;
  }

  void leave() {
    const Step step = way_.back();
    way_.pop_back();
    int& mark = mark_[at(step.node)];
    const bool reaches_earlier = mark < step.number;
    if (reaches_earlier) {
      open_.push_back(step.node);
    } else {
      close(step);
    }
    if (!way_.empty()) {
      int& before = mark_[at(way_.back().node)];
      before = std::min(before, mark);
    }
  }

  // `step` and what was left open since is one component.
  void close(const Step& step) {
    while (!open_.empty() && mark_[at(open_.back())] >= step.number) {
      mark_[at(open_.back())] = last_mark - components_;
      open_.pop_back();
      --met_;
    }
    mark_[at(step.node)] = last_mark - components_++;
    --met_;
  }

  const Digraph& graph_;
  std::vector<int> mark_;  // one for each node
  std::vector<int> open_;  // nodes left whose component is not complete
  std::vector<Step> way_;
  int met_ = 0;  // nodes met whose component is not complete
  int components_ = 0;
};

bool has_loop(const Digraph& graph, int node) {
  return std::ranges::count(graph.heads(node), node) > 0;
}

// Nodes of each component; 0 where it cannot be walked.
std::vector<int> walkable_sizes(const Digraph& graph, const std::vector<int>& component) {
  std::vector<int> sizes(at(graph.nodes()), 0);
  for (const int c : component) ++sizes[at(c)];
  for (int node = 0; node < graph.nodes(); ++node) {
    int& size = sizes[at(component[at(node)])];
    if (size == 1 && !has_loop(graph, node)) size = 0;
  }
  return sizes;
}

}  // namespace

Digraph::Digraph(int nodes, std::span<const Arc> arcs)
    : first_(at(nodes) + 1, 0), order_(arcs.size()), heads_(arcs.size()) {
  for (const Arc& arc : arcs) {
    assert(arc.from >= 0 && arc.from < nodes && arc.to >= 0 && arc.to < nodes && "arcs lie within");
    ++first_[at(arc.from) + 1];
  }
  for (std::size_t node = 0; node < at(nodes); ++node) first_[node + 1] += first_[node];
  std::vector<int> free(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const std::size_t place = at(free[at(arcs[i].from)]++);
    order_[place] = static_cast<int>(i);
    heads_[place] = arcs[i].to;
  }
}

std::vector<int> strong_components(const Digraph& graph) { return ComponentSearch(graph).run(); }

std::vector<bool> largest_component(const Digraph& graph) {
  const std::vector<int> component = strong_components(graph);
  const std::vector<int> sizes = walkable_sizes(graph, component);
  int best = -1, best_size = 0;
  for (const int c : component) {  // in order of nodes
    if (sizes[at(c)] <= best_size) continue;
    best = c;
    best_size = sizes[at(c)];
  }
  std::vector<bool> kept(component.size());
  for (std::size_t node = 0; node < kept.size(); ++node) kept[node] = component[node] == best;
  return kept;
}

std::vector<int> depth_first(const Digraph& graph, int start, const std::vector<bool>& kept) {
  std::vector<int> met;
  std::vector<bool> open = kept;  // and not met yet
  std::vector<std::span<const int>> ahead;
  const auto enter = [&](int node) {
    if (!open[at(node)]) return;
    open[at(node)] = false;
    met.push_back(node);
    ahead.push_back(graph.heads(node));
  };
  enter(start);
  while (!ahead.empty()) {
    if (ahead.back().empty()) {
      ahead.pop_back();
      continue;
    }
    const int next = ahead.back().front();
    ahead.back() = ahead.back().subspan(1);
    enter(next);
  }
  return met;
}

}  // namespace promenade::motion
