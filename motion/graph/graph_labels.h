// The labels that walks over a motion graph can show, and how far each place is from one.
#pragma once

#include <string>
#include <vector>

#include "motion/graph/motion_graph.h"

namespace promenade::motion {

// The labels of all edges, each once, in order of the alphabet.
std::vector<std::string> edge_labels(const MotionGraph& graph);

// Throws an InputError about the graph if no edge has the label.
void require_label(const MotionGraph& graph, const std::string& label);

// For each node, the fewest frames of other labels until an edge with the label can be taken
// (Dijkstra); -1: never.
std::vector<int> frames_before(const MotionGraph& graph, const std::string& label);

}  // namespace promenade::motion
