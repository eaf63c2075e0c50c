// Weights of the k nearest examples ([N] 5.5, Kovar & Gleicher 2004), for points on
// the map and in any space of parameters.
#pragma once

#include <Eigen/Dense>

namespace promenade::motion {

// N weights, w_i ~ 1/d_i - 1/d_(k+1) for the k nearest columns of `points` (M x N), 0
// for the others, sum 1; 1/d_i without the second term when k >= N. At an example its
// weight is 1 (shared by examples at one place). When the k+1 nearest are equally far,
// all at that distance are equal. `weights` is resized; allocation-free when it has N.
void nearest_weights(const Eigen::MatrixXd& points, const Eigen::Ref<const Eigen::VectorXd>& at,
                     int k, Eigen::VectorXd& weights);
Eigen::VectorXd nearest_weights(const Eigen::MatrixXd& points,
                                const Eigen::Ref<const Eigen::VectorXd>& at, int k);

// The column of `points` nearest to `at`; the first of several.
int nearest_column(const Eigen::MatrixXd& points, const Eigen::Ref<const Eigen::VectorXd>& at);

}  // namespace promenade::motion
