#include "motion/models/dendrogram_layout.h"

#include <algorithm>
#include <cassert>

namespace promenade::motion {
namespace {

const Merge& merge_of(const Dendrogram& tree, int node) {
  return tree.merges[static_cast<std::size_t>(node - tree.leaves)];
}

// Leaves from the top; without recursion, since a tree can be as deep as it has leaves.
std::vector<int> ordered_leaves(const Dendrogram& tree) {
  std::vector<int> order;
  std::vector<int> waiting;
  if (tree.leaves > 0) waiting.push_back(tree.leaves + static_cast<int>(tree.merges.size()) - 1);
  while (!waiting.empty()) {
    const int node = waiting.back();
    waiting.pop_back();
    if (node < tree.leaves) {
      order.push_back(node);
      continue;
    }
    const Merge& merge = merge_of(tree, node);
    const bool swapped = height_of(tree, merge.b) < height_of(tree, merge.a);
    waiting.push_back(swapped ? merge.a : merge.b);
    waiting.push_back(swapped ? merge.b : merge.a);
  }
  return order;
}

}  // namespace

double height_of(const Dendrogram& tree, int node) {
  return node < tree.leaves ? 0 : merge_of(tree, node).height;
}

DendrogramLayout dendrogram_layout(const Dendrogram& tree) {
  DendrogramLayout layout{ordered_leaves(tree), {}};
  layout.rows.resize(layout.order.size());
  for (std::size_t i = 0; i < layout.order.size(); ++i) {
    layout.rows[static_cast<std::size_t>(layout.order[i])] = static_cast<double>(i);
  }
  for (const Merge& merge : tree.merges) {
    layout.rows.push_back((layout.rows[static_cast<std::size_t>(merge.a)] +
                           layout.rows[static_cast<std::size_t>(merge.b)]) /
                          2);
  }
  return layout;
}

double cut_height(const Dendrogram& tree, int k) {
  assert(k >= 1 && k <= std::max(1, tree.leaves) && "between one cluster and one for each leaf");
  if (tree.merges.empty()) return 1;
  const auto kept = static_cast<std::size_t>(tree.leaves - k);  // merges below the cut
  const double below = kept == 0 ? 0 : tree.merges[kept - 1].height;
  if (k == 1) return 1.05 * below;
  return (below + tree.merges[kept].height) / 2;
}

int clusters_at(const Dendrogram& tree, double height) {
  const auto below = std::count_if(tree.merges.begin(), tree.merges.end(),
                                   [height](const Merge& one) { return one.height <= height; });
  return tree.leaves - static_cast<int>(below);
}

std::vector<int> clusters_of_nodes(const Dendrogram& tree, const std::vector<int>& cluster) {
  std::vector<int> nodes = cluster;
  for (const Merge& merge : tree.merges) {
    const int a = nodes[static_cast<std::size_t>(merge.a)];
    const int b = nodes[static_cast<std::size_t>(merge.b)];
    nodes.push_back(a == b ? a : -1);
  }
  return nodes;
}

}  // namespace promenade::motion
