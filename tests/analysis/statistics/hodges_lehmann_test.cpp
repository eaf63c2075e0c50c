#include "analysis/statistics/hodges_lehmann.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace promenade::analysis {
namespace {

std::optional<LocationInterval> interval_of(const std::vector<double>& d, double level) {
  return hodges_lehmann_interval(WalshAverages(d), static_cast<int>(d.size()), level);
}

TEST(HodgesLehmann, IsTheMedianOfTheWalshAverages) {
  // 1 1.5 2 | 3 3.5 5: averages of {1, 2, 5} with themselves and one another
  EXPECT_EQ(hodges_lehmann(WalshAverages({5, 1, 2})), 2.5);
}

TEST(HodgesLehmann, OfNothingIsNothing) {
  EXPECT_FALSE(hodges_lehmann(WalshAverages({})));
  EXPECT_FALSE(interval_of({}, 0.95));
}

TEST(HodgesLehmann, DoesNotOverflow) {
  EXPECT_DOUBLE_EQ(*hodges_lehmann(WalshAverages({1.6e308, 1.7e308})), 1.65e308);
}

// With n values the widest interval has level 1 - 2/2^n: 0.9375 for 5, 0.96875 for 6.
TEST(HodgesLehmann, HasNoIntervalOf95PercentForFiveValues) {
  EXPECT_FALSE(interval_of({1, 2, 3, 4, 5}, 0.95));
  const auto six = interval_of({1, 2, 3, 4, 5, 6}, 0.95);
  ASSERT_TRUE(six);
  EXPECT_EQ(six->level, 0.96875);
  EXPECT_EQ(six->interval.lower, 1);
  EXPECT_EQ(six->interval.upper, 6);
}

// Tables of the signed-rank test: for n = 13, P(W <= 17) <= 0.025 < P(W <= 18).
TEST(HodgesLehmann, GoesInAsFarAsTheTableOfTheTestSays) {
  std::vector<double> d(13);
  std::iota(d.begin(), d.end(), 1.0);
  const WalshAverages walsh(d);
  const auto interval = interval_of(d, 0.95);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->interval.lower, walsh[17]);
  EXPECT_EQ(interval->interval.upper, walsh[walsh.size() - 18]);
}

TEST(HodgesLehmann, WidensWithTheLevel) {
  const std::vector<double> d = {0.3, -1.2, 4.4, 2.5, 0.9, -0.1, 3.3, 1.7, 2.2, 0.4};
  const auto narrow = interval_of(d, 0.90);
  const auto wide = interval_of(d, 0.99);
  ASSERT_TRUE(narrow && wide);
  EXPECT_LE(wide->interval.lower, narrow->interval.lower);
  EXPECT_GE(wide->interval.upper, narrow->interval.upper);
  EXPECT_GE(narrow->level, 0.90);
  EXPECT_GE(wide->level, 0.99);
}

// At the limit of exact counts both ways to cut must agree closely.
TEST(HodgesLehmann, MeetsTheNormalApproximationWhereItTakesOver) {
  std::vector<double> d(2001);
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = std::sin(static_cast<double>(i * i)) + 0.1;
  const auto normal = interval_of(d, 0.95);
  d.pop_back();
  const auto exact = interval_of(d, 0.95);
  ASSERT_TRUE(exact && normal);
  EXPECT_NEAR(exact->interval.lower, normal->interval.lower, 0.002);
  EXPECT_NEAR(exact->interval.upper, normal->interval.upper, 0.002);
}

TEST(ShiftEstimate, IsTheMedianOfAllDifferences) {
  EXPECT_EQ(shift_estimate({1, 4}, {0, 2}), 1.5);  // -1 1 | 2 4
  EXPECT_FALSE(shift_estimate({}, {1}));
}

// P(U = 0) = 1/20 for 3 and 3: the widest interval does not reach 95 %; R gives it anyway.
TEST(ShiftInterval, IsTheWholeRangeForFewValuesAndMissingWithTies) {
  const auto interval = shift_interval({1, 2, 4}, {0.5, 0.7, 5}, 0.95);
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->lower, 1 - 5.0);
  EXPECT_EQ(interval->upper, 4 - 0.5);
  EXPECT_FALSE(shift_interval({1, 2}, {2, 3}, 0.95));
}

}  // namespace
}  // namespace promenade::analysis
