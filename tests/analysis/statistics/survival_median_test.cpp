#include "analysis/statistics/survival_median.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

Survival maintained() {  // Miller 1981: leukaemia, the maintained group; + is censored
  return kaplan_meier({{9, true},
                       {13, true},
                       {13, false},
                       {18, true},
                       {23, true},
                       {28, false},
                       {31, true},
                       {34, true},
                       {45, false},
                       {48, true},
                       {161, false}});
}

// With R from S and Greenwood's sum: lower ends .508, .447, ... at 9, 13, ...; the upper ends
// stay above 1/2.
TEST(MedianTime, IsBetweenTheTimesAtWhichTheIntervalsCrossOneHalf) {
  const MedianTimeInterval interval = median_time_interval(maintained());
  EXPECT_EQ(interval.lower, 13);
  EXPECT_FALSE(interval.upper);
}

TEST(MedianTime, HasBothEndsWhereManyAreDone) {
  std::vector<Duration> durations;
  for (int i = 1; i <= 40; ++i) durations.push_back({static_cast<double>(i), true});
  const Survival survival = kaplan_meier(durations);
  const MedianTimeInterval interval = median_time_interval(survival);
  EXPECT_EQ(survival.median, 20);
  // log(-log S) -+ 1.96 sqrt((1 - S) / (n S)) / log S: R has S = .65 (.482, .776) at 14 and
  // S = .375 (.229, .521) at 25, S = .35 (.208, .496) at 26.
  EXPECT_EQ(interval.lower, 14);
  EXPECT_EQ(interval.upper, 26);
}

TEST(MedianTime, IsNotKnownWhereNobodyIsDone) {
  const MedianTimeInterval interval = median_time_interval(kaplan_meier({{5, false}, {6, false}}));
  EXPECT_FALSE(interval.lower || interval.upper);
}

}  // namespace
}  // namespace promenade::analysis
