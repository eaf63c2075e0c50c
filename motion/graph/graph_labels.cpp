#include "motion/graph/graph_labels.h"

#include <queue>
#include <set>
#include <utility>

#include "motion/did_you_mean.h"
#include "motion/graph/digraph.h"
#include "motion/graph/index.h"
#include "motion/problem.h"

namespace promenade::motion {
namespace {

// Arcs have the numbers of edges and lead the other way.
Digraph backwards(const MotionGraph& graph) {
  std::vector<Arc> arcs;
  for (const GraphEdge& edge : graph.edges) arcs.push_back({edge.to, edge.from});
  return {static_cast<int>(graph.nodes.size()), arcs};
}

using Way = std::pair<int, int>;  // frames, and the node where they begin

}  // namespace

std::vector<int> frames_before(const MotionGraph& graph, const std::string& label) {
  const Digraph back = backwards(graph);
  std::vector<int> frames(graph.nodes.size(), -1);
  std::priority_queue<Way, std::vector<Way>, std::greater<>> open;
  for (const GraphEdge& edge : graph.edges) {
    if (graph.label(edge) == label) open.emplace(0, edge.from);
  }
  while (!open.empty()) {
    const auto [before, node] = open.top();
    open.pop();
    if (frames[at(node)] >= 0) continue;
    frames[at(node)] = before;
    for (const int e : back.leaving(node)) {
      const GraphEdge& edge = graph.edge(e);
      if (frames[at(edge.from)] < 0) open.emplace(before + edge.frames, edge.from);
    }
  }
  return frames;
}

std::vector<std::string> edge_labels(const MotionGraph& graph) {
  std::set<std::string> labels;
  for (const GraphEdge& edge : graph.edges) labels.insert(graph.label(edge));
  return {labels.begin(), labels.end()};
}

void require_label(const MotionGraph& graph, const std::string& label) {
  const std::vector<std::string> labels = edge_labels(graph);
  for (const std::string& one : labels) {
    if (one == label) return;
  }
  throw InputError(graph.name, "shows no \"" + label + "\"" + did_you_mean(label, labels) +
                                   "; its labels are " + quoted_list(labels));
}

}  // namespace promenade::motion
