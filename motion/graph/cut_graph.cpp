#include "motion/graph/cut_graph.h"

#include <algorithm>
#include <tuple>

namespace promenade::motion {
namespace {

bool before(const GraphNode& a, const GraphNode& b) {
  return std::tie(a.take, a.frame) < std::tie(b.take, b.frame);
}

std::vector<GraphNode> ends_of(const std::vector<Passage>& passages) {
  std::vector<GraphNode> nodes;
  nodes.reserve(2 * passages.size());
  for (const Passage& passage : passages) {
    nodes.push_back({passage.from_take, passage.transition.frames.i});
    nodes.push_back({passage.to_take, passage.transition.frames.j});
  }
  std::sort(nodes.begin(), nodes.end(), before);
  const auto same = [](const GraphNode& a, const GraphNode& b) {
    return a.take == b.take && a.frame == b.frame;
  };
  nodes.erase(std::unique(nodes.begin(), nodes.end(), same), nodes.end());
  return nodes;
}

int number_of(const std::vector<GraphNode>& nodes, const GraphNode& node) {
  return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), node, before) -
                          nodes.begin());
}

// Along the take first, then the best transition.
void sort_edges(MotionGraph& graph) {
  const auto key = [&graph](const GraphEdge& edge) {
    const double rms = edge.transition < 0 ? -1.0 : graph.transition(edge.transition).rms_m;
    return std::tuple(edge.from, rms, edge.to, edge.transition);
  };
  std::sort(graph.edges.begin(), graph.edges.end(),
            [&](const GraphEdge& a, const GraphEdge& b) { return key(a) < key(b); });
}

// Transitions that no edge uses go; the others keep their order.
void drop_unused_transitions(MotionGraph& graph) {
  std::vector<int> moved(graph.transitions.size(), -1);
  for (const GraphEdge& edge : graph.edges) {
    if (edge.transition >= 0) moved[static_cast<std::size_t>(edge.transition)] = 0;
  }
  std::vector<GraphTransition> used;
  for (std::size_t t = 0; t < moved.size(); ++t) {
    if (moved[t] < 0) continue;
    moved[t] = static_cast<int>(used.size());
    used.push_back(std::move(graph.transitions[t]));
  }
  graph.transitions = std::move(used);
  for (GraphEdge& edge : graph.edges) {
    if (edge.transition >= 0) edge.transition = moved[static_cast<std::size_t>(edge.transition)];
  }
}

// New numbers of the kept nodes; -1: not kept.
std::vector<int> renumbered(const std::vector<bool>& kept) {
  std::vector<int> numbers;
  numbers.reserve(kept.size());
  int next = 0;
  for (const bool keep : kept) numbers.push_back(keep ? next++ : -1);
  return numbers;
}

void keep_nodes(const std::vector<bool>& kept, MotionGraph& graph) {
  const std::vector<int> number = renumbered(kept);
  std::vector<GraphNode> nodes;
  for (std::size_t n = 0; n < kept.size(); ++n) {
    if (kept[n]) nodes.push_back(graph.nodes[n]);
  }
  graph.nodes = std::move(nodes);
  std::erase_if(graph.edges, [&](const GraphEdge& edge) {
    return !kept[static_cast<std::size_t>(edge.from)] || !kept[static_cast<std::size_t>(edge.to)];
  });
  for (GraphEdge& edge : graph.edges) {
    edge.from = number[static_cast<std::size_t>(edge.from)];
    edge.to = number[static_cast<std::size_t>(edge.to)];
  }
  drop_unused_transitions(graph);
}

// Whether nothing but its take leads to a node and away from it.
std::vector<bool> goes_straight_on(const MotionGraph& graph) {
  std::vector<int> in(graph.nodes.size(), 0), out(graph.nodes.size(), 0);
  std::vector<bool> straight(graph.nodes.size(), true);
  for (const GraphEdge& edge : graph.edges) {
    const auto from = static_cast<std::size_t>(edge.from), to = static_cast<std::size_t>(edge.to);
    ++out[from];
    ++in[to];
    if (edge.transition >= 0) straight[from] = straight[to] = false;
  }
  for (std::size_t n = 0; n < straight.size(); ++n) {
    straight[n] = straight[n] && in[n] == 1 && out[n] == 1;
  }
  return straight;
}

}  // namespace

Digraph digraph_of(const MotionGraph& graph) {
  std::vector<Arc> arcs;
  arcs.reserve(graph.edges.size());
  for (const GraphEdge& edge : graph.edges) arcs.push_back({edge.from, edge.to});
  return {static_cast<int>(graph.nodes.size()), arcs};
}

void cut_at(std::vector<Passage> passages, MotionGraph& graph) {
  graph.nodes = ends_of(passages);
  for (std::size_t n = 1; n < graph.nodes.size(); ++n) {
    const GraphNode &a = graph.nodes[n - 1], &b = graph.nodes[n];
    if (a.take != b.take) continue;
    graph.edges.push_back({static_cast<int>(n) - 1, static_cast<int>(n), b.frame - a.frame, -1});
  }
  for (Passage& passage : passages) {
    const TransitionFrames& frames = passage.transition.frames;
    graph.edges.push_back({number_of(graph.nodes, {passage.from_take, frames.i}),
                           number_of(graph.nodes, {passage.to_take, frames.j}), frames.k - 1,
                           static_cast<int>(graph.transitions.size())});
    graph.transitions.push_back(std::move(passage.transition));
  }
  sort_edges(graph);
}

MotionGraph part_of(const MotionGraph& graph, const std::vector<bool>& kept) {
  MotionGraph part = graph;
  keep_nodes(kept, part);
  return part;
}

void join_straight_nodes(MotionGraph& graph) {
  const std::vector<bool> straight = goes_straight_on(graph);
  std::vector<int> onward(graph.nodes.size(), -1);  // the edge along the take
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const GraphEdge& edge = graph.edges[e];
    if (edge.transition < 0) onward[static_cast<std::size_t>(edge.from)] = static_cast<int>(e);
  }
  // Takes have ends, so every chain of such nodes has one.
  for (GraphEdge& edge : graph.edges) {
    if (edge.transition >= 0 || straight[static_cast<std::size_t>(edge.from)]) continue;
    while (straight[static_cast<std::size_t>(edge.to)]) {
      const GraphEdge& next = graph.edge(onward[static_cast<std::size_t>(edge.to)]);
      edge.frames += next.frames;
      edge.to = next.to;
    }
  }
  std::vector<bool> kept(straight.size());
  for (std::size_t n = 0; n < kept.size(); ++n) kept[n] = !straight[n];
  keep_nodes(kept, graph);
}

}  // namespace promenade::motion
