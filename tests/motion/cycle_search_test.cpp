#include "motion/cycle_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

const MotionSet& walkers() {
  static const MotionSet set = builtin_set("A").value();
  return set;
}

const Cycle& normal() { return walkers().cycles[0]; }

int frames_of(const Cycle& cycle) { return cycle_clip(walkers(), cycle).frames() - 1; }

CycleSearch search(const Take& take, const CycleSearchOptions& options = {}) {
  return find_cycles(take, find_contacts(take), options);
}

TEST(FindCycles, FindsTheWalkBetweenTwoTimesOfStanding) {
  const Take take = standing_around(walker_take(walkers(), normal(), 6), 90);
  const CycleSearch found = search(take);
  ASSERT_GE(found.candidates.size(), 4U);
  for (const CycleCandidate& cycle : found.candidates) {
    EXPECT_GT(cycle.first(), 80);
    EXPECT_LT(cycle.keys.back(), take.frames() - 80);
  }
  EXPECT_NEAR(found.candidates[0].length(), frames_of(normal()), 1);
  EXPECT_LT(found.candidates[0].loop_error_m, 0.005);
}

// Walks, turns round within one cycle, walks back, and so on.
Take there_and_back(int times) {
  const int frames = frames_of(normal());
  return turned(walker_take(walkers(), normal(), 4 * times), [frames](int f) {
    const int leg = f / (4 * frames);
    const double into = static_cast<double>(f % (4 * frames)) / frames - 3;
    return M_PI * (leg + std::clamp(into, 0.0, 1.0));
  });
}

TEST(FindCycles, LeavesOutEveryTurnOfALongTake) {
  const CycleSearch found = search(there_and_back(6));
  EXPECT_GE(found.candidates.size(), 9U);
  for (const CycleCandidate& cycle : found.candidates) {
    EXPECT_LT(std::abs(cycle.turn), 0.45);
    EXPECT_GT(cycle.straightness, 0.97);
  }
  for (std::size_t best = 0; best < 6; ++best) {
    EXPECT_LT(std::abs(found.candidates[best].turn), 0.02);
    EXPECT_LT(found.candidates[best].loop_error_m, 0.005);
  }
  EXPECT_NE(found.refusal.find("turn"), std::string::npos);
}

TEST(FindCycles, RefusesACircleUnlessItIsAskedFor) {
  const double frames = frames_of(normal());
  const Take circle =
      turned(walker_take(walkers(), normal(), 5), [frames](int f) { return 0.8 * f / frames; });
  const CycleSearch refused = search(circle);
  EXPECT_TRUE(refused.candidates.empty());
  EXPECT_EQ(refused.refusal, "3 turn");
  CycleSearchOptions wide;
  wide.most_turn = 1;
  const CycleSearch found = search(circle, wide);
  ASSERT_FALSE(found.candidates.empty());
  EXPECT_NEAR(found.candidates[0].turn, 0.8, 0.05);
}

TEST(FindCycles, RefusesACycleThatTurnsThereAndBackAgain) {
  const double frames = frames_of(normal());
  const Take waves = turned(walker_take(walkers(), normal(), 5),
                            [frames](int f) { return 0.7 * std::sin(2 * M_PI * f / frames); });
  EXPECT_TRUE(search(waves).candidates.empty());
}

TEST(FindCycles, FindsTheLoopOfATakeThatBeginsInTheMiddle) {
  const Take whole = walker_take(walkers(), normal(), 2);
  const int frames = frames_of(normal());
  const Take once = part(whole, frames / 3, frames / 3 + frames);
  EXPECT_TRUE(search(once).candidates.empty());
  const Take again = unrolled(once);
  EXPECT_EQ(again.period, frames);
  const CycleSearch found = search(again);
  ASSERT_FALSE(found.candidates.empty());
  EXPECT_NEAR(found.candidates[0].length(), frames, 1);
  EXPECT_LT(found.candidates[0].loop_error_m, 0.005);
}

TEST(GivenCycle, IsMeasuredAsItStands) {
  const Take take = walker_take(walkers(), normal(), 3);
  const double frames = frames_of(normal());
  const CycleCandidate cycle = given_cycle(take, {10, 30, 10 + frames});
  EXPECT_LT(cycle.loop_error_m, 1e-9);
  EXPECT_NEAR(cycle.turn, 0, 1e-9);
  const PoseGap half = pose_gap(take, 10, 10 + std::floor(frames / 2));
  EXPECT_GT(half.position_m, 0.05);
}

TEST(GivenCycle, SaysWhatIsWrongWithItsKeytimes) {
  const Take take = part(walker_take(walkers(), normal(), 3), 20, 60);
  EXPECT_EQ(trouble_with_keys(take, {0, 10, 40}), "");
  EXPECT_EQ(trouble_with_keys(take, {0, 41}), "has frames 20 to 60, and the cycle lies outside");
  EXPECT_EQ(trouble_with_keys(take, {-1, 10}), "has frames 20 to 60, and the cycle lies outside");
  EXPECT_NE(trouble_with_keys(take, {0, 20, 20, 30}), "");
  EXPECT_NE(trouble_with_keys(take, {3, 4}), "");
}

}  // namespace
}  // namespace promenade::motion
