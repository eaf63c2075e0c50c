// Linear prediction of several values from features, with a penalty (ridge regression),
// and its error on motions that it has not seen: adjectives of a new motion without
// people, which [O] names as its future work.
#pragma once

#include <Eigen/Dense>

namespace promenade::motion {

struct Ridge {
  Eigen::VectorXd mean, scale;     // of the features, K; scale 0: does not vary, not used
  Eigen::MatrixXd coefficients;    // M x K, of standardised features
  Eigen::VectorXd intercept;       // M
  double penalty = 0;              // lambda, on standardised features
  Eigen::MatrixXd left_out;        // M x N: prediction of each example by the others
  Eigen::VectorXd error;           // M: root mean square of those predictions' errors
  Eigen::VectorXd baseline_error;  // M: the same when the mean of the others is the guess
};

// Features K x N and values M x N, one column an example, N >= 3. The penalty with the
// least left-out error is taken, from 1e-3 N to 1e5 N. Left-out predictions are exact
// for that penalty and this standardisation: y_i - (y_i - f_i) / (1 - h_ii).
Ridge fit_ridge(const Eigen::MatrixXd& features, const Eigen::MatrixXd& values);
Ridge fit_ridge(const Eigen::MatrixXd& features, const Eigen::MatrixXd& values, double penalty);

// M values of K features.
Eigen::VectorXd predict(const Ridge& ridge, const Eigen::VectorXd& features);

}  // namespace promenade::motion
