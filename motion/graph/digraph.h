// Directed graphs as lists of arcs: what can be reached from where. Nothing here recurses: graphs
// of long takes are deep.
#pragma once

#include <span>
#include <vector>

namespace promenade::motion {

struct Arc {
  int from = 0, to = 0;
};

// Arcs by where they start, in the order in which they were given: O(1) to find.
class Digraph {
 public:
  // Nodes are 0 .. nodes - 1; every arc lies within.
  Digraph(int nodes, std::span<const Arc> arcs);

  int nodes() const { return static_cast<int>(first_.size()) - 1; }
  int arcs() const { return static_cast<int>(heads_.size()); }
  // Numbers of the arcs that leave a node, and where they lead, in the same order.
  std::span<const int> leaving(int node) const { return of(order_, node); }
  std::span<const int> heads(int node) const { return of(heads_, node); }

 private:
  std::span<const int> of(const std::vector<int>& row, int node) const {
    const auto at = static_cast<std::size_t>(node);
    return std::span(row).subspan(static_cast<std::size_t>(first_[at]),
                                  static_cast<std::size_t>(first_[at + 1] - first_[at]));
  }

  std::vector<int> first_;  // nodes + 1: where a node's arcs begin in order_ and heads_
  std::vector<int> order_;  // numbers of arcs
  std::vector<int> heads_;  // where these lead
};

// For each node the number of its strongly connected component, from 0, no number left out:
// from each of its nodes all others can be reached. An arc between two components leads to the
// smaller number. (Tarjan 1972, with one number per node as Pearce 2016 has it.)
std::vector<int> strong_components(const Digraph& graph);

// Whether each node is in the largest component that can be walked without end; of equals the
// one with the smallest node. A single node can be walked only when an arc leads back to it, so
// where no way closes, no node is kept.
std::vector<bool> largest_component(const Digraph& graph);

// Nodes in the order in which depth-first search from `start` meets them, arcs in their order,
// nodes that are not `kept` (one for each node) left out, `start` included.
std::vector<int> depth_first(const Digraph& graph, int start, const std::vector<bool>& kept);

}  // namespace promenade::motion
