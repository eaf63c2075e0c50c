// Where a dendrogram is drawn: leaves in rows, merges between them, and where it is cut.
#pragma once

#include <vector>

#include "motion/models/ward.h"

namespace promenade::motion {

// Nodes are leaves, then merges, as in Merge.
struct DendrogramLayout {
  std::vector<int> order;    // leaves from the top; as R orders them, the tighter cluster first
  std::vector<double> rows;  // of each node: leaves at 0, 1, ... from the top, merges in between
};

DendrogramLayout dendrogram_layout(const Dendrogram& tree);

// 0 of a leaf.
double height_of(const Dendrogram& tree, int node);

// The height of a cut into k clusters, in the middle between two merges (1 <= k <= leaves).
double cut_height(const Dendrogram& tree, int k);

// How many clusters a cut at this height leaves.
int clusters_at(const Dendrogram& tree, double height);

// The cluster of each node, by the labels of the leaves; -1 where a merge joins several.
std::vector<int> clusters_of_nodes(const Dendrogram& tree, const std::vector<int>& cluster);

}  // namespace promenade::motion
