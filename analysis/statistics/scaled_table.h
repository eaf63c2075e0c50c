// Tables of ratings as matrices whose squares neither overflow nor vanish.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace promenade::analysis {

// x = values 2^exponent, to the last bit but for numbers 1e-300 of the largest; that one lies
// between 1/2 and 1.
struct ScaledTable {
  Eigen::MatrixXd values;
  int exponent = 0;
};

// Finite rows of equal length, at least one row and column.
ScaledTable scaled_table(const std::vector<std::vector<double>>& x);

}  // namespace promenade::analysis
