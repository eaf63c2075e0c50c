// Ward's hierarchical clustering: which adjective pairs mean the same to people, and
// which motion features move together ([O] Eqs. 4-6).
//
// The price of a merge is n1 n2 / (n1 + n2) ||M1 - M2||^2, the growth of the sum of
// squares. Heights are the square root of twice that (R's ward.D2, SciPy's ward), so
// two single points merge at their distance. Nearest-neighbour chain, O(n^2) time.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace promenade::motion {

struct Merge {
  int a = 0, b = 0;   // a < b: leaves are 0 to n-1, merge t makes cluster n + t
  double height = 0;  // never less than that of a and b
  int size = 0;       // leaves in the new cluster

  double cost() const { return height * height / 2; }  // n1 n2 / (n1 + n2) ||M1 - M2||^2
};

struct Dendrogram {
  int leaves = 0;
  std::vector<Merge> merges;  // leaves - 1, by rising height
};

// Clusters the columns of `points` (d x n). Of several nearest clusters the one that
// was met before in the chain, then the one with the smallest leaf is taken, so the
// tree is the same on every machine. O(n) memory.
Dendrogram ward(const Eigen::MatrixXd& points);

// From an n x n symmetric matrix of dissimilarities, treated as Euclidean distances
// (Lance-Williams on their squares), whether they are or not. O(n^2) memory.
Dendrogram ward_of_distances(const Eigen::MatrixXd& distances);

// Label of each leaf when the tree is cut into k clusters (1 <= k <= n), numbered by
// first appearance.
std::vector<int> cut(const Dendrogram& tree, int k);

// Leaves of each merge, ascending.
std::vector<std::vector<int>> merged_leaves(const Dendrogram& tree);

// n x n: the height at which two leaves first share a cluster.
Eigen::MatrixXd cophenetic_distances(const Dendrogram& tree);

// Correlation of the distances with the cophenetic ones, over all pairs i < j.
double cophenetic_correlation(const Dendrogram& tree, const Eigen::MatrixXd& distances);

// n x n Euclidean distances of the columns of `points` (d x n).
Eigen::MatrixXd euclidean_distances(const Eigen::MatrixXd& points);

}  // namespace promenade::motion
