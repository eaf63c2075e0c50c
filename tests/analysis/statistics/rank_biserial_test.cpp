#include "analysis/statistics/rank_biserial.h"

#include <gtest/gtest.h>

#include <numeric>

namespace promenade::analysis {
namespace {

// n untied differences; the last `positive` of their magnitudes are positive.
std::optional<Interval> interval_of(int n, int positive) {
  std::vector<double> d;
  for (int i = 1; i <= n; ++i) d.push_back(i > n - positive ? i : -i);
  return rank_biserial_interval(wilcoxon(d), 0.95);
}

// By R: p2 as an integral with integrate(), the ends with uniroot().
TEST(RankBiserial, HasTheEndsThatRFindsByIntegration) {
  const auto all = interval_of(13, 13);
  EXPECT_NEAR(all->lower, 0.4768997047, 2e-9);
  EXPECT_EQ(all->upper, 1);
  const auto six = interval_of(6, 6);
  EXPECT_NEAR(six->lower, 0.1174174512, 2e-9);
}

// W+ = 13 + 12 + 11 + 10 + 9 + 8 + 5 = 68, so r = 45/91.
TEST(RankBiserial, HasThemAlsoInTheMiddle) {
  const std::vector<double> d = {-1, -2, -3, -4, 5, -6, -7, 8, 9, 10, 11, 12, 13};
  const SignedRankTest test = wilcoxon(d);
  ASSERT_NEAR(*test.rank_biserial, 45.0 / 91, 1e-15);
  const auto interval = rank_biserial_interval(test, 0.95);
  EXPECT_NEAR(interval->lower, -0.1165568858, 2e-9);
  EXPECT_NEAR(interval->upper, 0.8071935708, 2e-9);
}

TEST(RankBiserial, TurnsWithTheSigns) {
  const auto all = interval_of(13, 13);
  const auto none = interval_of(13, 0);
  EXPECT_EQ(none->lower, -1);
  EXPECT_EQ(none->upper, -all->lower);
}

TEST(RankBiserial, SaysNothingOfFewerThanTwoDifferences) {
  EXPECT_FALSE(rank_biserial_interval(wilcoxon({}), 0.95));
  EXPECT_FALSE(rank_biserial_interval(wilcoxon({0, 0, 3}), 0.95));
  EXPECT_TRUE(rank_biserial_interval(wilcoxon({0, -2, 3}), 0.95));
}

}  // namespace
}  // namespace promenade::analysis
