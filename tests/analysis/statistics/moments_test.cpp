#include "analysis/statistics/moments.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

// R 4.2.2: x <- c(3, 5, 4, 8, 7.5, 2); t <- t.test(x); mean(x); sd(x); t$conf.int
TEST(Moments, AgreeWithR) {
  const Moments moments = moments_of({3, 5, 4, 8, 7.5, 2});
  EXPECT_EQ(moments.n, 6);
  EXPECT_NEAR(*moments.mean, 4.916667, 1e-6);
  EXPECT_NEAR(*moments.sd, 2.416954, 1e-6);
  EXPECT_NEAR(moments.mean_ci->lower, 2.380229, 1e-6);
  EXPECT_NEAR(moments.mean_ci->upper, 7.453104, 1e-6);
}

// R: x <- c(3.1, 4.7, 1.2, 9.9, 5); t.test(x, conf.level = 0.90)$conf.int; sd(x)
TEST(Moments, HaveTheIntervalOfAnotherLevel) {
  const Moments moments = moments_of({3.1, 4.7, 1.2, 9.9, 5}, 0.90);
  EXPECT_NEAR(moments.mean_ci->lower, 1.69404592265764, 1e-10);
  EXPECT_NEAR(moments.mean_ci->upper, 7.86595407734236, 1e-10);
  EXPECT_NEAR(*moments.sd, 3.23681942653587, 1e-12);
}

TEST(Moments, OfOneValueHaveNoSpread) {
  const Moments moments = moments_of({3});
  EXPECT_EQ(*moments.mean, 3);
  EXPECT_FALSE(moments.sd);
  EXPECT_FALSE(moments.mean_ci);
}

TEST(Moments, OfNoValueAreNothing) { EXPECT_FALSE(moments_of({}).mean); }

TEST(Moments, OfEqualValuesHaveAnIntervalOfNoWidth) {
  const Moments moments = moments_of({4, 4, 4});
  EXPECT_EQ(moments.mean_ci->lower, 4);
  EXPECT_EQ(moments.mean_ci->upper, 4);
}

}  // namespace
}  // namespace promenade::analysis
