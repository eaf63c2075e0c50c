#include "analysis/statistics/kaplan_meier.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::analysis {
namespace {

// Nobody is stopped: S is the part that takes longer, its error that of a proportion, the
// restricted mean the mean of the times cut at tau, with the error of a mean (by n).
TEST(KaplanMeier, WithoutCensoringIsThePlainProportion) {
  const std::vector<double> times = {3, 5, 5, 8, 13};
  std::vector<Duration> durations;
  for (const double time : times) durations.push_back({time, true});
  const Survival survival = kaplan_meier(durations);
  ASSERT_EQ(survival.steps.size(), 4u);
  EXPECT_NEAR(survival.steps[1].survival, 0.4, 1e-15);
  EXPECT_NEAR(*survival.steps[1].se, std::sqrt(0.4 * 0.6 / 5), 1e-15);
  EXPECT_FALSE(survival.steps[3].se);
  EXPECT_EQ(survival.median, 5);
  const RestrictedMean mean = restricted_mean(survival, 10);
  EXPECT_NEAR(mean.mean, (3 + 5 + 5 + 8 + 10) / 5.0, 1e-13);
  const double squares = 9 + 25 + 25 + 64 + 100;
  EXPECT_NEAR(mean.se, std::sqrt((squares / 5 - mean.mean * mean.mean) / 5), 1e-13);
}

// By hand: 6 at risk, 2 done at 50 (one stopped there counts as longer), 3, 1 done at 80.
TEST(KaplanMeier, CountsWhoWasStoppedUntilThen) {
  const Survival survival =
      kaplan_meier({{50, true}, {80, true}, {50, false}, {300, false}, {50, true}, {80, false}});
  ASSERT_EQ(survival.steps.size(), 3u);
  EXPECT_NEAR(survival.steps[0].survival, 4.0 / 6, 1e-15);
  EXPECT_EQ(survival.steps[1].at_risk, 3);
  EXPECT_NEAR(survival.steps[1].survival, 4.0 / 6 * 2 / 3, 1e-15);
  EXPECT_EQ(survival.steps[2].censored, 1);
  EXPECT_NEAR(restricted_mean(survival, 300).mean, 50 + 30 * 4.0 / 6 + 220 * 4.0 / 9, 1e-12);
}

TEST(KaplanMeier, HasTheMedianWhereHalfAreDone) {
  const Survival survival = kaplan_meier({{1, true}, {2, true}, {4, true}, {9, true}});
  EXPECT_EQ(survival.median, 2);
  EXPECT_EQ(survival.median_midpoint, 3);
  EXPECT_FALSE(kaplan_meier({{1, true}, {2, false}, {2, false}}).median);
}

TEST(KaplanMeier, IsCertainWhereNobodyIsDone) {
  const Survival survival = kaplan_meier({{60, false}, {60, false}});
  EXPECT_EQ(survival.steps[0].survival, 1);
  EXPECT_EQ(survival.steps[0].se, 0);
  EXPECT_FALSE(survival.steps[0].loglog);
  EXPECT_EQ(restricted_mean(survival, 60).mean, 60);
  EXPECT_TRUE(kaplan_meier({}).steps.empty());
}

// Two of four are done at 10: S = 1/2 from there, the area to the right 15 of a horizon of 40,
// so se = sqrt(15^2 2/(4 2)) = 7.5.
TEST(RestrictedMean, HasANormalIntervalWithinTheHorizon) {
  const Survival survival = kaplan_meier({{10, true}, {10, true}, {40, false}, {40, false}});
  const RestrictedMean mean = restricted_mean(survival, 40);
  EXPECT_EQ(mean.mean, 25);
  EXPECT_NEAR(mean.se, 7.5, 1e-14);
  EXPECT_NEAR(mean.interval.lower, 25 - 1.959963984540054 * 7.5, 1e-12);
  EXPECT_NEAR(mean.interval.upper, 25 + 1.959963984540054 * 7.5, 1e-12);
  const RestrictedMean wide = restricted_mean(kaplan_meier({{1, true}, {9, false}}), 10);
  EXPECT_EQ(wide.interval.lower, 0);
  EXPECT_EQ(wide.interval.upper, 10);
}

TEST(RestrictedMean, OfNobodyAndOfNoTimeIsTheHorizon) {
  EXPECT_EQ(restricted_mean(kaplan_meier({}), 7).mean, 7);
  EXPECT_EQ(restricted_mean(kaplan_meier({{5, true}}), 0).mean, 0);
  EXPECT_EQ(restricted_mean(kaplan_meier({{0, true}}), 7).mean, 0);
}

TEST(KaplanMeier, HasAMedianBetweenHugeTimes) {
  const Survival survival = kaplan_meier({{1.5e308, true}, {1.7e308, true}});
  EXPECT_EQ(survival.median_midpoint, 0.75e308 + 0.85e308);
}

}  // namespace
}  // namespace promenade::analysis
