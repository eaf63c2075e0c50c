#include "motion/quantile.h"

#include <gtest/gtest.h>

namespace promenade::motion {
namespace {

TEST(AQuantile, IsLinearBetweenOrderStatistics) {
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_DOUBLE_EQ(quantile({7}, 0.3), 7);
}

// R: quantile(c(1, 2, 4, 8, 16), c(.25, .5, .75, .1)) is 2, 4, 8, 1.4.
TEST(AQuantile, OfSortedValuesIsThatOfR) {
  const std::vector<double> x = {1, 2, 4, 8, 16};
  EXPECT_DOUBLE_EQ(quantile_of_sorted(x, 0.25), 2);
  EXPECT_DOUBLE_EQ(quantile_of_sorted(x, 0.75), 8);
  EXPECT_DOUBLE_EQ(quantile_of_sorted(x, 0.1), 1.4);
  EXPECT_DOUBLE_EQ(quantile_of_sorted({7}, 0.3), 7);
  EXPECT_DOUBLE_EQ(quantile_of_sorted(x, 1), 16);
}

}  // namespace
}  // namespace promenade::motion
