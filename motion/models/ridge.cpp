#include "motion/models/ridge.h"

#include <Eigen/Eigenvalues>
#include <cassert>
#include <cmath>
#include <limits>

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What does not depend on the penalty. The Gram matrix of the N examples is small
// however many features there are: X (X^T X + lambda)^-1 X^T = U l/(l + lambda) U^T.
struct Problem {
  VectorXd mean, scale, value_mean;
  MatrixXd features;  // K x N, standardised
  MatrixXd values;    // M x N, centred
  MatrixXd u;         // N x N
  VectorXd l;         // N
};

Problem pose_problem(const MatrixXd& features, const MatrixXd& values) {
  assert(features.cols() == values.cols() && features.cols() >= 3 && "a few examples");
  Problem problem;
  problem.mean = features.rowwise().mean();
  problem.features = features.colwise() - problem.mean;
  problem.scale =
      problem.features.rowwise().norm() / std::sqrt(static_cast<double>(features.cols() - 1));
  for (Index k = 0; k < features.rows(); ++k) {
    if (problem.scale(k) > 1e-12 * features.row(k).cwiseAbs().maxCoeff()) {
      problem.features.row(k) /= problem.scale(k);
    } else {
      problem.scale(k) = 0;
      problem.features.row(k).setZero();
    }
  }
  problem.value_mean = values.rowwise().mean();
  problem.values = values.colwise() - problem.value_mean;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(problem.features.transpose() *
                                                       problem.features);
  problem.u = solver.eigenvectors();
  problem.l = solver.eigenvalues().cwiseMax(0);
  return problem;
}

// Errors of the left-out predictions, M x N.
MatrixXd left_out_errors(const Problem& problem, double penalty) {
  const auto n = static_cast<double>(problem.u.rows());
  const VectorXd shrink = problem.l.array() / (problem.l.array() + penalty);
  const MatrixXd hat = problem.u * shrink.asDiagonal() * problem.u.transpose();
  MatrixXd errors = problem.values - problem.values * hat;
  for (Index i = 0; i < errors.cols(); ++i) errors.col(i) /= 1 - 1 / n - hat(i, i);
  return errors;
}

VectorXd root_mean_square(const MatrixXd& errors) {
  return (errors.rowwise().squaredNorm() / static_cast<double>(errors.cols())).cwiseSqrt();
}

Ridge solve(const Problem& problem, const MatrixXd& values, double penalty) {
  Ridge ridge;
  ridge.mean = problem.mean;
  ridge.scale = problem.scale;
  ridge.penalty = penalty;
  ridge.intercept = problem.value_mean;
  const VectorXd inverse = (problem.l.array() + penalty).inverse();
  ridge.coefficients = problem.values * problem.u * inverse.asDiagonal() * problem.u.transpose() *
                       problem.features.transpose();
  const MatrixXd errors = left_out_errors(problem, penalty);
  ridge.left_out = values - errors;
  ridge.error = root_mean_square(errors);
  const auto n = static_cast<double>(values.cols());
  ridge.baseline_error = root_mean_square(problem.values) * (n / (n - 1));
  return ridge;
}

}  // namespace

Ridge fit_ridge(const MatrixXd& features, const MatrixXd& values, double penalty) {
  assert(penalty > 0 && "without a penalty the examples are met exactly");
  return solve(pose_problem(features, values), values, penalty);
}

Ridge fit_ridge(const MatrixXd& features, const MatrixXd& values) {
  const Problem problem = pose_problem(features, values);
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int step = -6; step <= 10; ++step) {
    const double penalty = static_cast<double>(values.cols()) * std::pow(10, 0.5 * step);
    const double error = left_out_errors(problem, penalty).squaredNorm();
    if (error >= least) continue;
    least = error;
    best = penalty;
  }
  return solve(problem, values, best);
}

VectorXd predict(const Ridge& ridge, const VectorXd& features) {
  assert(features.size() == ridge.mean.size() && "one value for each feature");
  const VectorXd centred = features - ridge.mean;
  const VectorXd standard =
      (ridge.scale.array() > 0).select(centred.array() / ridge.scale.array(), 0);
  return ridge.intercept + ridge.coefficients * standard;
}

}  // namespace promenade::motion
