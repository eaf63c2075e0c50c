#include "motion/graph/planar_move.h"

#include <gtest/gtest.h>

#include "motion/angles.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

const PlanarMove far_turn{2.8, 0.4, -1.2};
const PlanarMove turn_back{1.9, -3, 0.5};
const Vector3d point(0.3, 1.1, -0.7);
constexpr double rounding = 1e-14;

TEST(PlanarMove, IsTheMoveOfTheFormula) {
  const Vector3d there = moved(far_turn, point);
  EXPECT_NEAR(there.x(), 0.3 * std::cos(2.8) - 0.7 * std::sin(2.8) + 0.4, rounding);
  EXPECT_EQ(there.y(), 1.1);
  EXPECT_NEAR(there.z(), -0.3 * std::sin(2.8) - 0.7 * std::cos(2.8) - 1.2, rounding);
}

TEST(PlanarMove, OneAfterAnotherIsBothInTurn) {
  const PlanarMove both = after(turn_back, far_turn);
  EXPECT_LT((moved(both, point) - moved(turn_back, moved(far_turn, point))).norm(), rounding);
  EXPECT_NEAR(both.theta, 2.8 + 1.9 - 2 * pi, rounding);
}

TEST(PlanarMove, TheInverseTakesItBack) {
  EXPECT_LT((moved(inverse(far_turn), moved(far_turn, point)) - point).norm(), rounding);
}

TEST(PlanarMove, APoseMovesAsItsPointsDo) {
  Pose pose{point, {Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vector3d::UnitX()))}};
  const Vector3d tip(0.1, 0.2, 0.3);
  const Vector3d before = pose.root + pose.rotations[0] * tip;
  const Pose there = moved(far_turn, pose);
  EXPECT_LT((there.root + there.rotations[0] * tip - moved(far_turn, before)).norm(), rounding);
}

}  // namespace
}  // namespace promenade::motion
