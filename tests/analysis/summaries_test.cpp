#include "analysis/summaries.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/median.h"
#include "tests/analysis/toy_dataset.h"

namespace promenade::analysis {
namespace {

Dataset three_people() {
  Dataset data;
  data.measures = {{"time_s", "time", "s", "s", 1, 1}};
  data.tasks = {{"match", {"happy", "old"}, {}, {}}};
  data.interfaces = {"labels", "weights"};
  data.people = {"P1", "P2", "P3"};
  data.trials = {{0, 0, 0, 0, 1, "success", false, {2.0}},
                 {1, 0, 0, 0, 1, "timeout", true, {4.0}},
                 {2, 0, 0, 1, 1, "done", true, {9.0}}};
  return data;
}

TEST(Summaries, HaveMeanSpreadAndMedian) {
  const auto all = summaries(three_people());
  ASSERT_EQ(all.size(), 1u) << "nobody used weights";
  EXPECT_EQ(all[0].n, 3);
  EXPECT_EQ(all[0].mean, 5);
  EXPECT_DOUBLE_EQ(*all[0].sd, std::sqrt((9.0 + 1 + 16) / 2));
  EXPECT_EQ(all[0].median, 4);
  EXPECT_FALSE(all[0].median_ci) << "three values are too few";
}

TEST(TargetSummaries, StandForEachTargetByItself) {
  const auto all = target_summaries(three_people());
  ASSERT_EQ(all.size(), 2u) << "two targets with labels";
  EXPECT_EQ(all[0].target, 0);
  EXPECT_EQ(all[0].n, 2);
  EXPECT_EQ(all[0].mean, 3);
  EXPECT_EQ(all[0].median, 3);
  EXPECT_DOUBLE_EQ(*all[0].sd, std::sqrt(2.0));
  EXPECT_EQ(all[0].least, 2);
  EXPECT_EQ(all[0].most, 4);
  EXPECT_EQ(all[1].n, 1);
  EXPECT_FALSE(all[1].sd);
}

// Exactly: the p with P(Bin(1, p) >= 1) = .025.
TEST(FailureRatios, HaveTheExactIntervalToo) {
  const auto ratios = failure_ratios(three_people());
  EXPECT_NEAR(ratios[2].clopper_pearson.lower, 0.025, 1e-12);
  EXPECT_EQ(ratios[2].clopper_pearson.upper, 1);
}

TEST(FailureRatios, CountTrialsOfAllTargetsAndOfEach) {
  const auto ratios = failure_ratios(three_people());
  ASSERT_EQ(ratios.size(), 3u);
  EXPECT_EQ(ratios[0].target, -1);
  EXPECT_EQ(ratios[0].failed, 2);
  EXPECT_EQ(ratios[0].timeouts, 1);
  EXPECT_EQ(ratios[0].trials, 3);
  EXPECT_EQ(ratios[1].failed, 1);
  EXPECT_EQ(ratios[1].trials, 2);
  EXPECT_EQ(ratios[2].wilson.upper, 1);
}

// P(Bin(6, 1/2) = 0) = 1/64 <= 0.025; for 5 it is 1/32. For 9: P(<= 1) = 10/512 <= 0.025
// < P(<= 2) = 46/512.
TEST(MedianInterval, EndsAtTheOrderStatisticsOfTheSignTest) {
  EXPECT_FALSE(median_interval({1, 2, 3, 4, 5}, 0.95));
  EXPECT_EQ(median_interval({6, 1, 2, 3, 4, 5}, 0.95)->lower, 1);
  const auto nine = median_interval({1, 2, 3, 4, 5, 6, 7, 8, 9}, 0.95);
  EXPECT_EQ(nine->lower, 2);
  EXPECT_EQ(nine->upper, 8);
}

TEST(Median, OfAnEvenNumberIsTheMiddleOfTwo) {
  EXPECT_EQ(median_of({4, 1, 3, 2}), 2.5);
  EXPECT_FALSE(median_of({}));
}

TEST(FailureRatios, LeaveOutTasksThatCannotFail) {
  Dataset data = toy_dataset(3, 2, 1, [](int, int, int) { return std::optional(5.0); });
  EXPECT_EQ(failure_ratios(data).size(), 4u);
  data.tasks[0].limit_s.reset();
  EXPECT_TRUE(failure_ratios(data).empty());
}

}  // namespace
}  // namespace promenade::analysis
