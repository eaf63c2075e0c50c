#include "motion/models/nearest.h"

#include <gtest/gtest.h>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const MatrixXd line = (MatrixXd(1, 5) << 0, 1, 3, 6, 10).finished();

VectorXd at(double x) { return VectorXd::Constant(1, x); }

TEST(NearestWeights, ArePlainInverseDistancesForAll) {
  const VectorXd weights = nearest_weights(line, at(2), 5);
  VectorXd expected(5);
  expected << 1.0 / 2, 1, 1, 1.0 / 4, 1.0 / 8;
  EXPECT_LE((weights - expected / expected.sum()).norm(), 1e-15);
}

TEST(NearestWeights, FadeAtTheFirstOneLeftOut) {
  const VectorXd weights = nearest_weights(line, at(2.5), 2);  // 3: 0.5, 1: 1.5, 0: 2.5
  VectorXd expected(5);
  expected << 0, 1 / 1.5 - 1 / 2.5, 1 / 0.5 - 1 / 2.5, 0, 0;
  EXPECT_LE((weights - expected / expected.sum()).norm(), 1e-15);
}

TEST(NearestWeights, AreTheExampleAtAnExample) {
  const MatrixXd points = Random(1).normals(3, 12);
  for (int k : {1, 5, 12}) {
    for (int j = 0; j < 12; ++j) {
      EXPECT_EQ(nearest_weights(points, points.col(j), k), VectorXd::Unit(12, j));
    }
  }
}

TEST(NearestWeights, AreSharedByExamplesAtOnePlace) {
  const MatrixXd points = (MatrixXd(1, 3) << 4, 4, 5).finished();
  EXPECT_EQ(nearest_weights(points, at(4), 2), Eigen::Vector3d(0.5, 0.5, 0));
}

TEST(NearestWeights, AreEqualWhenAllAreEquallyFar) {
  const MatrixXd points = (MatrixXd(2, 4) << 1, -1, 0, 0, 0, 0, 1, -1).finished();
  EXPECT_EQ(nearest_weights(points, VectorXd::Zero(2), 2), VectorXd::Constant(4, 0.25));
}

TEST(NearestWeights, DoNotJumpWhenTheNeighboursChange) {
  Random random(2);
  const MatrixXd points = random.normals(2, 20);
  VectorXd before = nearest_weights(points, VectorXd(Eigen::Vector2d(-2, 0.31)), 5);
  for (int step = 1; step <= 40000; ++step) {
    const VectorXd now =
        nearest_weights(points, VectorXd(Eigen::Vector2d(-2 + step * 1e-4, 0.31)), 5);
    EXPECT_NEAR(now.sum(), 1, 1e-12);
    EXPECT_LT((now - before).cwiseAbs().maxCoeff(), 0.02) << "at step " << step;
    before = now;
  }
}

TEST(NearestWeights, SurviveTinyAndHugeDistances) {
  const MatrixXd points = (MatrixXd(1, 3) << 1e-200, 3e-200, 1e200).finished();
  const VectorXd weights = nearest_weights(points, at(0), 3);
  EXPECT_TRUE(weights.allFinite());
  EXPECT_NEAR(weights.sum(), 1, 1e-15);
}

TEST(TheNearestColumn, IsTheFirstOfSeveral) {
  EXPECT_EQ(nearest_column(line, at(2)), 1);
  EXPECT_EQ(nearest_column(line, at(8.5)), 4);
}

}  // namespace
}  // namespace promenade::motion
