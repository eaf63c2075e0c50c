// Directed graphs as lists of edges: what can be reached from where.
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
  // Numbers of the arcs that leave a node.
  std::span<const int> leaving(int node) const;
  int head(int arc) const { return heads_[static_cast<std::size_t>(arc)]; }

 private:
  std::vector<int> first_;  // nodes + 1: where a node's arcs begin in order_
  std::vector<int> order_;  // numbers of arcs
  std::vector<int> heads_;  // of each arc
};

// For each node the number of its strongly connected component, from 0 (Tarjan 1972, without
// recursion: takes can be long).
std::vector<int> strong_components(const Digraph& graph);

// Whether each node is in the largest component; of equals the one with the smallest node.
std::vector<bool> largest_component(const Digraph& graph);

// Nodes in the order in which depth-first search from `start` meets them, arcs in their order,
// nodes that are not `kept` left out.
std::vector<int> depth_first(const Digraph& graph, int start, const std::vector<bool>& kept);

}  // namespace promenade::motion
