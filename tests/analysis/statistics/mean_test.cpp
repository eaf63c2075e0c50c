#include "analysis/statistics/mean.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

// R: x <- c(3.1, 4.7, 1.2, 9.9, 5); t.test(x, conf.level = 0.90)$conf.int; sd(x)
TEST(MeanInterval, IsThatOfR) {
  const std::vector<double> x = {3.1, 4.7, 1.2, 9.9, 5};
  const Interval ci = *mean_interval(x, 0.90);
  EXPECT_NEAR(ci.lower, 1.69404592265764, 1e-10);
  EXPECT_NEAR(ci.upper, 7.86595407734236, 1e-10);
  EXPECT_NEAR(*mean_and_sd(x)->sd, 3.23681942653587, 1e-12);
}

TEST(MeanInterval, NeedsTwoValues) {
  EXPECT_FALSE(mean_interval({}, 0.9));
  EXPECT_FALSE(mean_interval({2}, 0.9));
  EXPECT_FALSE(mean_and_sd({}));
  EXPECT_EQ(mean_and_sd({2})->mean, 2);
  EXPECT_FALSE(mean_and_sd({2})->sd);
}

TEST(MeanInterval, OfEqualValuesIsAPoint) {
  const Interval ci = *mean_interval({0.25, 0.25, 0.25}, 0.9);
  EXPECT_EQ(ci.lower, 0.25);
  EXPECT_EQ(ci.upper, 0.25);
}

}  // namespace
}  // namespace promenade::analysis
