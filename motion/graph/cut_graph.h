// Takes cut at the places where transitions leave and enter them, and what can be done with the
// pieces.
#pragma once

#include "motion/graph/digraph.h"
#include "motion/graph/motion_graph.h"

namespace promenade::motion {

// A transition before there are nodes to lead between.
struct Passage {
  int from_take = 0, to_take = 0;
  GraphTransition transition;
};

// Gives `graph`, which has takes and nothing else, its nodes, edges and transitions.
void cut_at(std::vector<Passage> passages, MotionGraph& graph);

// Leaves these nodes alone (one value for each node), with the edges between them and the
// transitions of these edges.
void keep_nodes(const std::vector<bool>& kept, MotionGraph& graph);
// The same of a copy.
MotionGraph part_of(const MotionGraph& graph, const std::vector<bool>& kept);

// Where a take merely goes on, there is nothing to choose: its two edges become one.
void join_straight_nodes(MotionGraph& graph);

Digraph digraph_of(const MotionGraph& graph);  // arcs have the numbers of edges

}  // namespace promenade::motion
