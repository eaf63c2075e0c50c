#include "motion/models/search.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::motion {
namespace {

using Eigen::VectorXd;

Box unit_box(int n) { return {VectorXd::Constant(n, -1), VectorXd::Constant(n, 1)}; }

TEST(ASearch, FindsTheBottomOfACurvedValley) {
  const Objective banana = [](const VectorXd& x) {
    return 100 * std::pow(x(1) - x(0) * x(0), 2) + std::pow(1 - x(0), 2);
  };
  const Box box{VectorXd::Constant(2, -2), VectorXd::Constant(2, 2)};
  const SearchResult found = minimise(banana, box, Eigen::Vector2d(-1.2, 1));
  EXPECT_LE((found.at - VectorXd::Ones(2)).norm(), 0.02);
}

TEST(ASearch, StaysInItsBoxAndFindsMinimaOnItsWalls) {
  const Objective slope = [](const VectorXd& x) {
    EXPECT_LE(x.cwiseAbs().maxCoeff(), 1);
    return x.sum() + 10;
  };
  const SearchResult found = minimise(slope, unit_box(4), VectorXd::Zero(4));
  EXPECT_NEAR(found.value, 6, 1e-3);
}

TEST(ASearch, WorksInAsManyDimensionsAsThereAreWeights) {
  const VectorXd goal = VectorXd::LinSpaced(27, -0.9, 0.9);
  const Objective bowl = [&goal](const VectorXd& x) { return (x - goal).norm(); };
  const SearchResult found = minimise(bowl, unit_box(27), VectorXd::Zero(27));
  EXPECT_LE(found.value, 0.01);
  EXPECT_LE(found.evaluations, 2100);
}

TEST(ASearch, OfNothingIsItsStart) {
  const SearchResult found =
      minimise([](const VectorXd&) { return 3.0; }, unit_box(0), VectorXd(0));
  EXPECT_EQ(found.value, 3);
}

TEST(ASearch, LeavesASideOfNoLengthAlone) {
  Box box = unit_box(2);
  box.high(1) = -1;
  const SearchResult found =
      minimise([](const VectorXd& x) { return x.squaredNorm(); }, box, Eigen::Vector2d(0.4, -1));
  EXPECT_NEAR(found.at(0), 0, 1e-3);
  EXPECT_EQ(found.at(1), -1);
}

}  // namespace
}  // namespace promenade::motion
