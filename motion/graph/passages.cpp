#include "motion/graph/passages.h"

#include <queue>
#include <set>
#include <tuple>

#include "motion/did_you_mean.h"
#include "motion/graph/digraph.h"
#include "motion/problem.h"

namespace promenade::motion {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

double rms_of(const MotionGraph& graph, const GraphEdge& edge) {
  return edge.transition < 0 ? 0 : graph.transitions[at(edge.transition)].rms_m;
}

// Arcs have the numbers of edges and lead the other way.
Digraph backwards(const MotionGraph& graph) {
  std::vector<Arc> arcs;
  for (const GraphEdge& edge : graph.edges) arcs.push_back({edge.to, edge.from});
  return {static_cast<int>(graph.nodes.size()), arcs};
}

// The shortest passages, found from their ends.
class PassageSearch {
 public:
  explicit PassageSearch(const MotionGraph& graph)
      : graph_(graph),
        found_{std::vector<int>(graph.nodes.size(), -1), std::vector<int>(graph.nodes.size(), -1)} {
  }

  Passages run(const std::string& label) {
    const Digraph back = backwards(graph_);
    for (int e = 0; e < static_cast<int>(graph_.edges.size()); ++e) {
      if (shows(graph_, e, label)) open_.push({0, 0, graph_.edges[at(e)].from, -1});
    }
    while (!open_.empty()) {
      const Way way = open_.top();
      open_.pop();
      if (found_.frames[at(way.node)] < 0) settle(way, back);
    }
    return std::move(found_);
  }

 private:
  struct Way {
    int frames;
    double rms;  // sum over its transitions
    int node;    // where it begins
    int edge;    // its first; -1: none is needed
    bool operator>(const Way& other) const {
      return std::tie(frames, rms, node, edge) >
             std::tie(other.frames, other.rms, other.node, other.edge);
    }
  };

  void settle(const Way& way, const Digraph& back) {
    found_.frames[at(way.node)] = way.frames;
    found_.next[at(way.node)] = way.edge;
    for (const int e : back.leaving(way.node)) {
      const GraphEdge& edge = graph_.edges[at(e)];
      if (found_.frames[at(edge.from)] >= 0) continue;
      open_.push({way.frames + edge.frames, way.rms + rms_of(graph_, edge), edge.from, e});
    }
  }

  const MotionGraph& graph_;
  Passages found_;
  std::priority_queue<Way, std::vector<Way>, std::greater<>> open_;
};

}  // namespace

Passages passages_to(const MotionGraph& graph, const std::string& label) {
  return PassageSearch(graph).run(label);
}

std::vector<int> passage_from(const MotionGraph& graph, const Passages& passages, int node) {
  std::vector<int> edges;
  for (int e = passages.next[at(node)]; e >= 0; e = passages.next[at(graph.edges[at(e)].to)]) {
    edges.push_back(e);
  }
  return edges;
}

bool shows(const MotionGraph& graph, int edge, const std::string& label) {
  return graph.label(graph.edges[at(edge)]) == label;
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
