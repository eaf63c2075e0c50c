// How a walk over a motion graph comes to a label: over as few frames of other labels as there
// can be (Dijkstra), and of equal ways by the transitions that are the most alike.
#pragma once

#include <string>
#include <vector>

#include "motion/graph/motion_graph.h"

namespace promenade::motion {

struct Passages {
  // For each node, frames of other labels until an edge with the label can be taken; -1: never.
  std::vector<int> frames;
  // For each node, the edge with which the passage goes on; -1: the label can follow at once,
  // or never.
  std::vector<int> next;
};

Passages passages_to(const MotionGraph& graph, const std::string& label);

// The edges of the passage from a node.
std::vector<int> passage_from(const MotionGraph& graph, const Passages& passages, int node);

// Whether the edge has the label.
bool shows(const MotionGraph& graph, int edge, const std::string& label);

// The labels of all edges, each once, in order of the alphabet.
std::vector<std::string> edge_labels(const MotionGraph& graph);

// Throws an InputError about the graph if no edge has the label.
void require_label(const MotionGraph& graph, const std::string& label);

}  // namespace promenade::motion
