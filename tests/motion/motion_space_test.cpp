#include "motion/motion_space.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

// Largest angle between rotations of two cycles, radians.
double turn_between(const Cycle& a, const Cycle& b) {
  double most = 0;
  for (Eigen::Index c = 0; c < a.rotations.cols(); ++c) {
    const Eigen::Quaterniond p(Eigen::Vector4d(a.rotations.col(c)));
    most =
        std::max(most, p.angularDistance(Eigen::Quaterniond(Eigen::Vector4d(b.rotations.col(c)))));
  }
  return most;
}

Eigen::VectorXd unit(int size, int at) { return Eigen::VectorXd::Unit(size, at); }

TEST(MotionSpace, AUnitWeightGivesTheExample) {
  const MotionSpace space = make_motion_space(toy_set(4));
  for (int i = 0; i < 4; ++i) {
    const Cycle& example = space.set.cycles[static_cast<std::size_t>(i)];
    const Cycle made = blend(space, unit(4, i));
    EXPECT_LT(turn_between(made, example), 1e-7);  // an angle of 1e-15 in its cosine
    EXPECT_TRUE(made.root.row(1).isApprox(example.root.row(1), 1e-12));
    EXPECT_TRUE(made.velocity.isApprox(example.velocity, 1e-9));
    EXPECT_NEAR(made.seconds, example.seconds, 1e-12);
    const auto quaternions = [](const Cycle& c) { return c.rotations.cwiseAbs(); };
    EXPECT_LT((quaternions(made) - quaternions(example)).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(MotionSpace, TheAverageIgnoresTheOrderOfCyclesAndTheSignOfQuaternions) {
  MotionSet set = toy_set(5);
  const MotionSpace one = make_motion_space(set);
  std::reverse(set.cycles.begin(), set.cycles.end());
  set.cycles[2].rotations *= -1;
  const MotionSpace other = make_motion_space(set);
  EXPECT_LT((one.average - other.average).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((one.mean_height - other.mean_height).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(MotionSpace, BlendsOfTwoLieEvenlyBetweenThem) {
  const MotionSpace space = make_motion_space(toy_set(2));
  const Cycle half = blend(space, Eigen::Vector2d(0.5, 0.5));
  const MotionSet& set = space.set;
  for (int joint = 0; joint < set.skeleton.size(); ++joint) {
    const auto at = [&](const Cycle& c) {
      return Eigen::Quaterniond(Eigen::Vector4d(c.rotations.col(joint)));
    };
    const double left = at(half).angularDistance(at(set.cycles[0]));
    const double right = at(half).angularDistance(at(set.cycles[1]));
    EXPECT_NEAR(left, right, 1e-7);
    EXPECT_NEAR(left + right, at(set.cycles[0]).angularDistance(at(set.cycles[1])), 1e-7);
  }
  EXPECT_NEAR(half.seconds, 0.5 * (set.cycles[0].seconds + set.cycles[1].seconds), 1e-12);
}

TEST(MotionSpace, KeytimesStayInOrderUnderAnyWeights) {
  const MotionSpace space = make_motion_space(toy_set(3));
  const Cycle wild = blend(space, Eigen::Vector3d(9, -6, -2));
  EXPECT_TRUE(std::is_sorted(wild.keytimes.begin(), wild.keytimes.end()));
  EXPECT_EQ(wild.keytimes.back(), wild.seconds);
  EXPECT_TRUE(wild.rotations.allFinite());
}

}  // namespace
}  // namespace promenade::motion
