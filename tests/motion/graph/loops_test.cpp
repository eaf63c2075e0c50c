#include "motion/graph/loops.h"

#include <gtest/gtest.h>

#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

const MotionSet& walkers() {
  static const MotionSet set = *builtin_set("A");
  return set;
}

TEST(Loops, OfAWalkerAreItsCycles) {
  const Take take = walker_take(walkers(), walkers().cycles.front(), 4);
  const std::vector<Match> loops = find_loops(take);
  ASSERT_FALSE(loops.empty());
  const double seconds = (loops.front().start_b - loops.front().start_a) * take.frame_time;
  const double cycles = seconds / walkers().cycles.front().seconds;
  EXPECT_NEAR(cycles, std::round(cycles), take.frame_time);
  EXPECT_LT(loops.front().rms_m, 0.005);
}

TEST(Loops, AreSortedAndAsLongAsAskedFor) {
  const Take take = walker_take(walkers(), walkers().cycles.front(), 5);
  const std::vector<Match> loops =
      find_loops(take, {.shortest_s = 0.8, .longest_s = 1.6, .threshold_m = 0.2});
  ASSERT_FALSE(loops.empty());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double seconds = (loops[i].start_b - loops[i].start_a) * take.frame_time;
    EXPECT_GE(seconds, 0.8 - 1e-9);
    EXPECT_LE(seconds, 1.6 + 1e-9);
    EXPECT_LE(loops[i == 0 ? 0 : i - 1].rms_m, loops[i].rms_m);
  }
}

// Arms that swing on a body that stays: no walk, but a loop.
TEST(Loops, AreFoundInWhatIsNoWalk) {
  Take take = walker_take(walkers(), walkers().cycles.front(), 1);
  const Pose rest = take.poses.front();
  take.poses.clear();
  const int shoulder = take.body.joint[left_shoulder];
  for (int f = 0; f < 300; ++f) {
    Pose pose = rest;
    const double angle = std::sin(2 * M_PI * f / 90.0) + 0.4 * std::sin(4 * M_PI * f / 90.0);
    pose.rotations[static_cast<std::size_t>(shoulder)] =
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX());
    take.poses.push_back(pose);
  }
  take.frame_time = 1.0 / 60;
  const std::vector<Match> loops = find_loops(take, {.shortest_s = 1});
  ASSERT_FALSE(loops.empty());
  EXPECT_EQ((loops.front().start_b - loops.front().start_a) % 90, 0);
  EXPECT_LT(loops.front().rms_m, 1e-9);
}

TEST(Loops, ATakeOfOneFrameHasNone) {
  Take take = walker_take(walkers(), walkers().cycles.front(), 1);
  take.poses.resize(1);
  EXPECT_TRUE(find_loops(take).empty());
}

}  // namespace
}  // namespace promenade::motion
