#include "motion/graph/ground_path.h"

#include <gtest/gtest.h>

#include "motion/angles.h"
#include "motion/problem.h"

namespace promenade::motion {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector2d;

// Three metres along X, then four along Z.
Matrix2Xd corner() {
  Matrix2Xd points(2, 3);
  points << 0, 3, 3, 0, 0, 4;
  return points;
}

std::string trouble(const Matrix2Xd& points) {
  try {
    GroundPath path(points, "path.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(GroundPath, IsMeasuredAlongItsLegs) {
  const GroundPath path(corner());
  EXPECT_EQ(path.length(), 7);
  EXPECT_EQ(path.at(2), Vector2d(2, 0));
  EXPECT_EQ(path.at(3), Vector2d(3, 0));
  EXPECT_EQ(path.at(5), Vector2d(3, 2));
}

TEST(GroundPath, IsHeldAtBothEnds) {
  const GroundPath path(corner());
  EXPECT_EQ(path.at(-1), Vector2d(0, 0));
  EXPECT_EQ(path.at(7), Vector2d(3, 4));
  EXPECT_EQ(path.at(1e300), Vector2d(3, 4));
}

TEST(GroundPath, HasTheDirectionOfWhatFollowsACorner) {
  const GroundPath path(corner());
  EXPECT_EQ(path.direction(0), Vector2d(1, 0));
  EXPECT_EQ(path.direction(3), Vector2d(0, 1));
  EXPECT_EQ(path.direction(9), Vector2d(0, 1));
}

TEST(GroundPath, FindsEveryPointOfUnequalLegs) {
  Matrix2Xd points(2, 200);
  for (int i = 0; i < 200; ++i) points.col(i) << (i % 20 == 0 ? 3.0 : 0.001) + 3.0 * i, i % 3;
  const GroundPath path(points);
  double reached = 0;
  for (Eigen::Index i = 1; i < 200; ++i) {
    const double leg = (points.col(i) - points.col(i - 1)).norm();
    const Vector2d middle = 0.5 * (points.col(i) + points.col(i - 1));
    EXPECT_LT((path.at(reached + 0.5 * leg) - middle).norm(), 1e-11) << i;
    reached += leg;
  }
}

TEST(GroundPath, LeavesRepeatedPointsOut) {
  Matrix2Xd points(2, 4);
  points << 0, 0, 1, 1, 0, 0, 0, 0;
  const GroundPath path(points);
  EXPECT_EQ(path.corners().cols(), 2);
  EXPECT_EQ(path.at(0.25), Vector2d(0.25, 0));
}

TEST(GroundPath, SaysWhatIsWrongWithPoints) {
  EXPECT_EQ(trouble(corner().leftCols(1)), "path.csv: error: a path needs at least two points");
  EXPECT_EQ(trouble(Matrix2Xd::Ones(2, 5)),
            "path.csv: error: all points of the path lie in one place");
  Matrix2Xd broken = corner();
  broken(1, 1) = std::nan("");
  EXPECT_EQ(trouble(broken), "path.csv: error: the points of a path are numbers of metres");
}

TEST(SmoothPath, GoesThroughEveryPointInSmallSteps) {
  const Matrix2Xd smooth = smooth_path(corner(), 0.05);
  for (Eigen::Index i = 0; i < 3; ++i) {
    EXPECT_LT((smooth.colwise() - corner().col(i)).colwise().norm().minCoeff(), 1e-12);
  }
  EXPECT_LT((smooth.rightCols(smooth.cols() - 1) - smooth.leftCols(smooth.cols() - 1))
                .colwise()
                .norm()
                .maxCoeff(),
            0.05);
}

TEST(SmoothPath, OfTwoPointsIsStraight) {
  const Matrix2Xd smooth = smooth_path(corner().leftCols(2));
  EXPECT_LT(smooth.row(1).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(GroundPath(smooth).length(), 3, 1e-12);
}

TEST(SmoothPath, OfPointsOnACircleStaysNearIt) {
  Matrix2Xd circle(2, 13);
  for (int i = 0; i < 13; ++i) circle.col(i) << 3 * std::cos(i * pi / 6), 3 * std::sin(i * pi / 6);
  const Matrix2Xd smooth = smooth_path(circle);
  // A chord of 30 degrees is 10 cm inside; the curve between inner points is within 1 cm.
  EXPECT_LT(std::abs(smooth.middleCols(40, smooth.cols() - 80).colwise().norm().minCoeff() - 3),
            0.01);
}

}  // namespace
}  // namespace promenade::motion
