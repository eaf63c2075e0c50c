// Principal components of motion offsets (docs/methods.md, 7), of any data, and their
// equal from distances, classical scaling. One rule: one column an example.
//
// The offsets have thousands of rows and few columns, so the components come from
// the Gram matrix G = U L U^T of the centred columns: coordinates alpha = U sqrt(L),
// and every point in the span is again a blend, w = 1/N + U L^(-1/2) alpha.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "motion/motion_space.h"

namespace promenade::motion {

struct Pca {
  Eigen::MatrixXd coordinates;  // R x N: example i in column i, largest variance first
  Eigen::VectorXd variances;    // R: lambda_k = L_k / (N - 1)
  double total_variance = 0;    // of all components: explained = variances / total

  int size() const { return static_cast<int>(coordinates.cols()); }        // N
  int components() const { return static_cast<int>(coordinates.rows()); }  // R < N
};

// Of the columns of x (D x N). Components whose standard deviation is below 1e-7 of the
// largest are left out: the Gram matrix cannot tell them from rounding. Sign of a
// component: the example with the largest |coordinate| is positive, the first by
// name if two tie (by column without names).
Pca principal_components(const Eigen::Ref<const Eigen::MatrixXd>& x,
                         const std::vector<std::string>& names = {});

// Of the rotations and heights of a motion set: what the map shows ([N] 5.5).
Pca principal_components(const MotionSpace& space);

// Coordinates (R) of the blend of weights w (N, sum 1).
Eigen::VectorXd coordinates_of(const Pca& pca, const Eigen::VectorXd& weights);

// Weights (N, sum 1, some may be negative) of a point given by its first K <= R
// coordinates; the others are 0.
Eigen::VectorXd weights_of(const Pca& pca, const Eigen::VectorXd& coordinates);

// The components of a table as statistics programs print them, by singular values.
struct TablePca {
  Eigen::VectorXd deviations;  // R, standard deviations (n - 1), falling
  Eigen::VectorXd explained;   // R, shares of the variance; sum 1
  Eigen::MatrixXd rotation;    // P x R, unit columns, entry of largest size positive
  Eigen::MatrixXd scores;      // n x R
};

// Of a table with n >= 2 rows (observations) and P columns (variables), centred and,
// on request, divided by the standard deviations. Components below 1e-9 of the
// largest are dropped. A column without variance is never divided.
TablePca table_components(const Eigen::MatrixXd& table, bool scale);

struct ClassicalScaling {
  Eigen::VectorXd eigenvalues;  // n, falling; those below 1e-12 of the largest are 0
  Eigen::MatrixXd points;       // k x n: point i in column i; k <= the number asked for
  // Sum of the k eigenvalues over that of all |eigenvalues|, and over the positive
  // ones; NaN when all points coincide.
  std::array<double, 2> goodness{};
};

// Classical multidimensional scaling: -1/2 J D^2 J of n x n distances, the first k
// axes with positive eigenvalues; the entry of largest size is positive.
ClassicalScaling classical_scaling(const Eigen::MatrixXd& distances, int k);

}  // namespace promenade::motion
