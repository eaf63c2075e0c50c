#include "motion/models/ward.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A cluster sits in a slot; merging moves the last active slot into the hole, so the
// active ones stay together and a scan is one pass over contiguous memory.
struct Slots {
  std::vector<int> node;       // in the raw list of merges: n + t, or a leaf
  std::vector<int> least;      // smallest leaf: breaks ties
  std::vector<double> count;   // leaves
  std::vector<double> height;  // of the cluster's own merge, squared
  int active = 0;

  explicit Slots(int n)
      : node(static_cast<std::size_t>(n)),
        count(static_cast<std::size_t>(n), 1),
        height(static_cast<std::size_t>(n), 0),
        active(n) {
    std::iota(node.begin(), node.end(), 0);
    least = node;
  }

  void merge(int into, int from, int new_node, double squared) {
    const auto i = static_cast<std::size_t>(into);
    const auto f = static_cast<std::size_t>(from);
    const auto last = static_cast<std::size_t>(--active);
    node[i] = new_node;
    least[i] = std::min(least[i], least[f]);
    count[i] += count[f];
    height[i] = squared;
    node[f] = node[last];
    least[f] = least[last];
    count[f] = count[last];
    height[f] = height[last];
  }
};

// Clusters as centroids: squared heights from the definition, O(n) memory.
class Centroids {
 public:
  explicit Centroids(const MatrixXd& points)
      : at_((points.colwise() - points.rowwise().mean()).transpose()), squares_(points.cols()) {}

  // Squared heights of merging slot `of` with every active slot.
  const VectorXd& scan(const Slots& slots, int of) {
    const Index active = slots.active;
    auto squares = squares_.head(active).array();
    squares.setZero();
    for (Index d = 0; d < at_.cols(); ++d) {
      squares += (at_.col(d).head(active).array() - at_(of, d)).square();
    }
    const Eigen::Map<const Eigen::ArrayXd> count(slots.count.data(), active);
    const double own = count(of);
    squares *= 2 * own * count / (own + count);
    return squares_;
  }

  void merge(const Slots& slots, int into, int from) {
    const double a = slots.count[static_cast<std::size_t>(into)];
    const double b = slots.count[static_cast<std::size_t>(from)];
    at_.row(into) = (a * at_.row(into) + b * at_.row(from)) / (a + b);
    at_.row(from) = at_.row(slots.active - 1);
  }

 private:
  MatrixXd at_;  // n x d
  VectorXd squares_;
};

// Clusters as columns of squared heights between them (Lance-Williams). A column stays in its
// place: in a large matrix every access along a row costs a cache miss.
class Squares {
 public:
  explicit Squares(const MatrixXd& distances)
      : squares_(distances.cwiseAbs2()),
        place_(static_cast<std::size_t>(distances.cols())),
        scan_(distances.cols()) {
    std::iota(place_.begin(), place_.end(), Index{0});
  }

  const VectorXd& scan(const Slots& slots, int of) {
    const double* const column = squares_.col(place(of)).data();
    for (int s = 0; s < slots.active; ++s) scan_(s) = column[place(s)];
    return scan_;
  }

  void merge(const Slots& slots, int into, int from) {
    const double a = slots.count[static_cast<std::size_t>(into)];
    const double b = slots.count[static_cast<std::size_t>(from)];
    auto merged = squares_.col(place(into));
    const auto lost = squares_.col(place(from));
    const double between = merged(place(from));
    for (int s = 0; s < slots.active; ++s) {
      const Index row = place(s);
      const double count = slots.count[static_cast<std::size_t>(s)];
      const double squared =
          ((a + count) * merged(row) + (b + count) * lost(row) - count * between) / (a + b + count);
      merged(row) = squared;
      squares_(place(into), row) = squared;
    }
    place_[static_cast<std::size_t>(from)] = place(slots.active - 1);
  }

 private:
  Index place(int slot) const { return place_[static_cast<std::size_t>(slot)]; }

  MatrixXd squares_;
  std::vector<Index> place_;  // of a slot: its row and column
  VectorXd scan_;             // a column in the order of the slots
};

struct Neighbour {
  int slot = -1;
  double squared = std::numeric_limits<double>::infinity();
};

// The nearest cluster to `of`. The one before it in the chain wins ties, without
// which the chain could run in circles.
template <typename Squared>
Neighbour nearest(const Slots& slots, const Squared& squared, int of, int before) {
  Neighbour best;
  if (before >= 0) best = {before, squared(before)};
  for (int s = 0; s < slots.active; ++s) {
    if (s == of || squared(s) > best.squared || s == before) continue;
    const bool tied = squared(s) == best.squared;
    if (tied && (best.slot == before || slots.least[static_cast<std::size_t>(s)] >
                                            slots.least[static_cast<std::size_t>(best.slot)]))
      continue;
    best = {s, squared(s)};
  }
  return best;
}

struct RawMerge {
  int a = 0, b = 0;
  double squared = 0;
  int size = 0;
};

template <typename Clusters>
std::vector<RawMerge> chain_merges(int n, Clusters clusters) {
  Slots slots(n);
  std::vector<RawMerge> merges;
  merges.reserve(static_cast<std::size_t>(std::max(0, n - 1)));
  std::vector<int> chain;
  while (slots.active > 1) {
    if (chain.empty()) {
      chain.push_back(static_cast<int>(
          std::min_element(slots.least.begin(), slots.least.begin() + slots.active) -
          slots.least.begin()));
    }
    const int tip = chain.back();
    const int before = chain.size() > 1 ? chain[chain.size() - 2] : -1;
    const Neighbour next = nearest(slots, clusters.scan(slots, tip), tip, before);
    if (next.slot != before) {
      chain.push_back(next.slot);
      continue;
    }
    chain.resize(chain.size() - 2);
    const auto i = static_cast<std::size_t>(std::min(tip, before));
    const auto f = static_cast<std::size_t>(std::max(tip, before));
    // Rounding alone could put a merge below those that it unites.
    const double squared = std::max({next.squared, slots.height[i], slots.height[f], 0.0});
    merges.push_back(
        {slots.node[i], slots.node[f], squared, static_cast<int>(slots.count[i] + slots.count[f])});
    clusters.merge(slots, static_cast<int>(i), static_cast<int>(f));
    const int last = slots.active - 1;
    slots.merge(static_cast<int>(i), static_cast<int>(f), n + static_cast<int>(merges.size()) - 1,
                squared);
    std::replace(chain.begin(), chain.end(), last, static_cast<int>(f));
  }
  return merges;
}

// The chain finds merges out of order: sorts them and numbers the clusters anew.
Dendrogram ordered(int n, const std::vector<RawMerge>& raw) {
  std::vector<int> order(raw.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&raw](int a, int b) {
    return raw[static_cast<std::size_t>(a)].squared < raw[static_cast<std::size_t>(b)].squared;
  });
  std::vector<int> renamed(static_cast<std::size_t>(n) + raw.size());
  std::iota(renamed.begin(), renamed.begin() + n, 0);
  Dendrogram tree{n, {}};
  tree.merges.reserve(raw.size());
  for (const int r : order) {
    const RawMerge& merge = raw[static_cast<std::size_t>(r)];
    const int a = renamed[static_cast<std::size_t>(merge.a)];
    const int b = renamed[static_cast<std::size_t>(merge.b)];
    renamed[static_cast<std::size_t>(n) + static_cast<std::size_t>(r)] =
        n + static_cast<int>(tree.merges.size());
    tree.merges.push_back({std::min(a, b), std::max(a, b), std::sqrt(merge.squared), merge.size});
  }
  return tree;
}

}  // namespace

Dendrogram ward(const MatrixXd& points) {
  const int n = static_cast<int>(points.cols());
  return ordered(n, chain_merges(n, Centroids(points)));
}

Dendrogram ward_of_distances(const MatrixXd& distances) {
  assert(distances.rows() == distances.cols() && "distances are a square");
  const int n = static_cast<int>(distances.cols());
  return ordered(n, chain_merges(n, Squares(distances)));
}

std::vector<int> cut(const Dendrogram& tree, int k) {
  assert(k >= 1 && k <= tree.leaves && "between one cluster and one for each leaf");
  const auto n = static_cast<std::size_t>(tree.leaves);
  // From the top down every cluster takes the name of the one it is in.
  std::vector<int> top(n + tree.merges.size());
  std::iota(top.begin(), top.end(), 0);
  for (std::size_t t = n - static_cast<std::size_t>(k); t-- > 0;) {
    top[static_cast<std::size_t>(tree.merges[t].a)] = top[n + t];
    top[static_cast<std::size_t>(tree.merges[t].b)] = top[n + t];
  }
  std::vector<int> labels(n);
  std::vector<int> number(top.size(), -1);
  int next = 0;
  for (std::size_t i = 0; i < n; ++i) {
    int& label = number[static_cast<std::size_t>(top[i])];
    if (label < 0) label = next++;
    labels[i] = label;
  }
  return labels;
}

std::vector<std::vector<int>> merged_leaves(const Dendrogram& tree) {
  std::vector<std::vector<int>> leaves(tree.merges.size());
  for (std::size_t t = 0; t < tree.merges.size(); ++t) {
    for (const int part : {tree.merges[t].a, tree.merges[t].b}) {
      if (part < tree.leaves) {
        leaves[t].push_back(part);
      } else {
        const auto& inner = leaves[static_cast<std::size_t>(part - tree.leaves)];
        leaves[t].insert(leaves[t].end(), inner.begin(), inner.end());
      }
    }
    std::sort(leaves[t].begin(), leaves[t].end());
  }
  return leaves;
}

MatrixXd cophenetic_distances(const Dendrogram& tree) {
  MatrixXd result = MatrixXd::Zero(tree.leaves, tree.leaves);
  const std::vector<std::vector<int>> leaves = merged_leaves(tree);
  for (std::size_t t = leaves.size(); t-- > 0;) {
    for (const int i : leaves[t]) {
      for (const int j : leaves[t]) {
        if (i != j) result(i, j) = tree.merges[t].height;
      }
    }
  }
  return result;
}

double cophenetic_correlation(const Dendrogram& tree, const MatrixXd& distances) {
  const MatrixXd merged = cophenetic_distances(tree);
  const Index n = distances.rows();
  VectorXd a(n * (n - 1) / 2);
  VectorXd b(a.size());
  for (Index i = 0, at = 0; i < n; ++i) {
    for (Index j = i + 1; j < n; ++j, ++at) {
      a(at) = distances(i, j);
      b(at) = merged(i, j);
    }
  }
  a.array() -= a.mean();
  b.array() -= b.mean();
  return a.dot(b) / (a.norm() * b.norm());
}

MatrixXd euclidean_distances(const MatrixXd& points) {
  MatrixXd distances(points.cols(), points.cols());
  for (Index i = 0; i < points.cols(); ++i) {
    distances.col(i) = (points.colwise() - points.col(i)).colwise().norm().transpose();
  }
  return distances;
}

}  // namespace promenade::motion
