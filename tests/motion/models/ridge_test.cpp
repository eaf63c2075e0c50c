#include "motion/models/ridge.h"

#include <gtest/gtest.h>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd without(const MatrixXd& x, Index column) {
  MatrixXd rest(x.rows(), x.cols() - 1);
  rest << x.leftCols(column), x.rightCols(x.cols() - 1 - column);
  return rest;
}

// Normal equations with an intercept that is not penalised, features standardised as
// in `ridge`.
VectorXd solved_directly(const Ridge& ridge, const MatrixXd& x, const MatrixXd& y,
                         const VectorXd& at, double penalty) {
  const auto standard = [&ridge](const MatrixXd& f) -> MatrixXd {
    return ridge.scale.cwiseInverse().asDiagonal() * MatrixXd(f.colwise() - ridge.mean);
  };
  MatrixXd design(x.rows() + 1, x.cols());
  design << standard(x), Eigen::RowVectorXd::Ones(x.cols());
  MatrixXd normal = design * design.transpose();
  normal.diagonal().head(x.rows()).array() += penalty;
  VectorXd point(x.rows() + 1);
  point << standard(at), 1;
  return y * design.transpose() * normal.ldlt().solve(point);
}

TEST(Ridge, SolvesTheNormalEquations) {
  Random random(1);
  const MatrixXd x = random.normals(4, 12), y = random.normals(2, 12);
  const VectorXd at = random.normals(4, 1);
  const Ridge ridge = fit_ridge(x, y, 3.0);
  EXPECT_LE((predict(ridge, at) - solved_directly(ridge, x, y, at, 3.0)).norm(), 1e-12);
}

TEST(Ridge, LeavesEachExampleOutAsIfItHadNeverBeen) {
  Random random(2);
  const MatrixXd x = random.normals(51, 10), y = random.normals(3, 10);
  const Ridge ridge = fit_ridge(x, y, 20.0);
  for (Index i = 0; i < 10; ++i) {
    const VectorXd direct = solved_directly(ridge, without(x, i), without(y, i), x.col(i), 20.0);
    EXPECT_LE((ridge.left_out.col(i) - direct).norm(), 1e-9);
  }
}

TEST(Ridge, ComparesWithTheMeanOfTheOthers) {
  const MatrixXd y = Random(3).normals(1, 7);
  double squares = 0;
  for (Index i = 0; i < 7; ++i) squares += std::pow(y(i) - without(y, i).mean(), 2);
  const Ridge ridge = fit_ridge(Random(4).normals(5, 7), y, 1.0);
  EXPECT_NEAR(ridge.baseline_error(0), std::sqrt(squares / 7), 1e-12);
}

TEST(Ridge, FindsALinearLawAndKnowsThatItDid) {
  Random random(5);
  const MatrixXd x = random.normals(3, 30);
  const MatrixXd y = random.normals(2, 3) * x;
  const Ridge ridge = fit_ridge(x, y);
  EXPECT_LT(ridge.error.maxCoeff(), 0.01 * ridge.baseline_error.minCoeff());
  const VectorXd truth = y.col(0);
  EXPECT_LE((predict(ridge, x.col(0)) - truth).norm(), 0.01);
}

TEST(Ridge, FindsNothingInNoise) {
  Random random(6);
  const Ridge ridge = fit_ridge(random.normals(51, 27), random.normals(4, 27));
  EXPECT_GT(ridge.error.mean(), 0.85 * ridge.baseline_error.mean());
}

TEST(Ridge, IgnoresFeaturesThatDoNotVary) {
  Random random(7);
  MatrixXd x = random.normals(3, 9);
  x.row(1).setConstant(4.2);
  const Ridge ridge = fit_ridge(x, random.normals(1, 9), 1.0);
  VectorXd at = random.normals(3, 1);
  const double before = predict(ridge, at)(0);
  at(1) = -7;
  EXPECT_EQ(predict(ridge, at)(0), before);
}

}  // namespace
}  // namespace promenade::motion
