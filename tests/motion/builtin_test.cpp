#include "motion/builtin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/distance.h"
#include "motion/gait/style.h"
#include "motion/motion_space.h"
#include "tests/motion/walk_measures.h"

namespace promenade::motion {
namespace {

const MotionSet& set_a() {
  static const MotionSet set = *builtin_set("A");
  return set;
}

WalkMeasures normal_walk() { return {set_a(), set_a().cycles[0]}; }

TEST(SetA, WalksAtOneSpeedInOneDirection) {
  for (const Cycle& cycle : set_a().cycles) {
    EXPECT_NEAR(cycle.velocity.x(), 0, 1e-12) << cycle.name;
    EXPECT_NEAR(cycle.velocity.y(), gait::walking_speed, 1e-12) << cycle.name;
  }
}

TEST(SetA, LooksDifferentInEveryStyle) {
  for (const Cycle& a : set_a().cycles) {
    for (const Cycle& b : set_a().cycles) {
      if (a.name >= b.name) continue;
      EXPECT_GT(distance(set_a(), a, b).mean_m, 0.05) << a.name << " and " << b.name;
    }
  }
}

// A threshold of half the median distance between styles must not be won by the
// average, where a trial may start.
TEST(SetA, LeavesAtLeastEightStylesFarFromItsAverage) {
  std::vector<double> between;
  for (const Cycle& a : set_a().cycles) {
    for (const Cycle& b : set_a().cycles) {
      if (a.name < b.name) between.push_back(distance(set_a(), a, b).mean_m);
    }
  }
  std::sort(between.begin(), between.end());
  const double threshold = 0.5 * between[between.size() / 2];
  const Cycle average = blend(make_motion_space(set_a()), Eigen::VectorXd::Constant(10, 0.1));
  const auto far =
      std::count_if(set_a().cycles.begin(), set_a().cycles.end(), [&](const Cycle& cycle) {
        return distance(set_a(), cycle, average).mean_m > 1.2 * threshold;
      });
  EXPECT_GE(far, 8);
}

TEST(SetA, AveragesToAWalkThatStaysNearTheGround) {
  const Cycle average = blend(make_motion_space(set_a()), Eigen::VectorXd::Constant(10, 0.1));
  const WalkMeasures walk(set_a(), average);
  const Range stance = walk.range(right_side, 0, 0.6, [&](const WorldPose& world) {
    return std::min(walk.heel(world, right_side).y(), walk.joint(world, right_toe).y() - 0.025);
  });
  EXPECT_GT(stance.least, -0.015);
  EXPECT_LT(stance.most, 0.015);
}

TEST(NormalWalk, HasTheFiguresOfNormalGait) {
  const Cycle& cycle = set_a().cycles[0];
  ASSERT_EQ(cycle.name, "normal");
  EXPECT_NEAR(120 / cycle.seconds, 110, 5);                             // cadence
  EXPECT_NEAR(0.5 * cycle.seconds * cycle.velocity.y(), 0.725, 0.025);  // step length
  EXPECT_NEAR(1 - cycle.keytimes[1] / cycle.seconds, 0.60, 0.01);       // stance
  EXPECT_NEAR((cycle.keytimes[2] - cycle.keytimes[1]) / cycle.seconds, 0.10, 0.01);
  const WalkMeasures walk = normal_walk();
  const Range height = walk.range(
      right_side, 0, 1, [&](const WorldPose& world) { return walk.joint(world, pelvis).y(); });
  EXPECT_NEAR(height.most - height.least, 0.045, 0.01);
  const Range sway = walk.range(
      right_side, 0, 1, [&](const WorldPose& world) { return walk.joint(world, pelvis).x(); });
  EXPECT_NEAR(sway.most - sway.least, 0.04, 0.005);
}

TEST(NormalWalk, BendsItsJointsAsPeopleDo) {
  const WalkMeasures walk = normal_walk();
  const auto hip = [&](const WorldPose& world) { return walk.hip_flexion(world, right_side); };
  const auto knee = [&](const WorldPose& world) { return walk.knee_flexion(world, right_side); };
  EXPECT_NEAR(walk.range(right_side, 0, 1, hip).most, 30, 4);
  EXPECT_NEAR(walk.range(right_side, 0, 1, hip).least, -12, 6);
  EXPECT_LT(knee(walk.at(right_side.strike)), 12);
  EXPECT_NEAR(walk.range(right_side, 0.08, 0.18, knee).most, 17.5, 3.5);
  EXPECT_NEAR(walk.range(right_side, 0.25, 0.45, knee).least, 7, 4);
  EXPECT_NEAR(walk.range(right_side, 0.6, 1, knee).most, 60, 4);
}

TEST(BuiltinName, IsWhatStandsBehindThePrefix) {
  EXPECT_EQ(builtin_name("builtin:A"), "A");
  EXPECT_EQ(builtin_name("builtin:"), "");
  EXPECT_FALSE(builtin_name("walks/builtin:A.set"));
  EXPECT_FALSE(builtin_name("A"));
}

TEST(BuiltinNames, AreThoseOfTheCyclesInTheirOrder) {
  for (const char* name : {"A", "B"}) EXPECT_EQ(builtin_names(name), names_of(*builtin_set(name)));
}

}  // namespace
}  // namespace promenade::motion
