// How alike two clusterings of the same items are: the adjusted Rand index (Hubert and
// Arabie 1985). 1: the same clusters, whatever their labels; 0: as alike as by chance, with
// clusters of these sizes; below 0: less.
#pragma once

#include <string>
#include <vector>

#include "motion/models/cluster_names.h"

namespace promenade::motion {

// Labels of each item, of equal length. 1 where both are one cluster, or all clusters are
// single items, and where there are fewer than two items.
double adjusted_rand_index(const std::vector<int>& a, const std::vector<int>& b);

// A clustering held against a printed one, over the items that are in both.
struct PrintedComparison {
  double rand_index = 1;
  std::vector<int> items;    // indices of those in both
  std::vector<int> missing;  // those that the printed clusters leave out
};

// `cluster`: labels of the items; `printed`: their printed clusters, "" for none.
PrintedComparison compare_with_printed(const std::vector<int>& cluster,
                                       const PrintedClusters& printed);

}  // namespace promenade::motion
