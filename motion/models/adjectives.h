// From people's ratings to a few primary adjective parameters ([O] 3-4, Eqs. 1-6;
// docs/methods.md, 8): means and deviations, pairs that say nothing dropped, the others
// scaled and clustered, and each cluster's mean.
#pragma once

#include <string>
#include <vector>

#include "motion/models/ward.h"

namespace promenade::motion {

struct Rating {
  int rater = 0;
  int pair = 0;      // 0 to P-1
  int motion = 0;    // 0 to N-1
  double value = 0;  // -2 (left pole) to 2 (right pole)
};

struct QuantificationOptions {
  double least_extreme = 1.0;    // a pair is dropped if mu*_j is less
  double most_deviation = 0.85;  // or if sigma_j is more
  int clusters = 4;
  // Pairs that correlate negatively with the other pairs of their cluster are turned
  // around before the mean is taken (ours).
  bool flip = false;
};

enum class PairFate { kept, never_extreme, disagreed, unrated };

// What the two thresholds make of a pair with this mu* and sigma; NaN: unrated.
PairFate fate_of(double extreme, double disagreement, const QuantificationOptions& options);

struct Quantification {
  Eigen::MatrixXd mean;          // P x N: mu_ij, -2 to 2; NaN where nobody rated
  Eigen::MatrixXd deviation;     // P x N: over raters, n - 1; NaN with fewer than two
  Eigen::VectorXd extreme;       // P: mu*_j = max_i |mu_ij|
  Eigen::VectorXd disagreement;  // P: sigma_j, mean deviation over the motions
  std::vector<PairFate> fate;    // P
  std::vector<int> kept;         // the Q pairs that are left, ascending
  Eigen::MatrixXd scaled;        // Q x N: A = (mu + 2) / 4, 0 to 1
  Dendrogram tree;               // of the rows of A
  std::vector<int> cluster;      // Q: 0 to C-1, by first appearance
  std::vector<bool> flipped;     // Q
  Eigen::MatrixXd primary;       // C x N: A', the mean of each cluster's rows
};

// Several ratings of one person, pair and motion count as one, their mean. A pair is
// unrated when a motion has no rating of it, or none has two. With fewer kept pairs
// than clusters each pair is a cluster of its own.
Quantification quantify(const std::vector<Rating>& ratings, int pairs, int motions,
                        const QuantificationOptions& = {});

// The same from A alone (rows of any kind in 0 to 1, P x N): clusters and means. The
// features take this path too, standardised for the tree, scaled for the means.
Quantification cluster_rows(const Eigen::MatrixXd& scaled, int clusters, bool flip = false);

// Pearson's, of the values of two parameters at the N examples; 0 where one does not vary.
double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b);

// Rows with mean 0 and standard deviation 1 (n - 1); a row that does not vary is 0.
Eigen::MatrixXd standardised(const Eigen::MatrixXd& rows);

// Rows from 0 (their least value) to 1 (their largest): sliders of features. A row that
// does not vary is 0.5.
Eigen::MatrixXd scaled_to_range(const Eigen::MatrixXd& rows);

// "mu* is below 1: no motion of this set is far from neutral", for a table of pairs.
std::string to_text(PairFate fate, const QuantificationOptions& options);

}  // namespace promenade::motion
