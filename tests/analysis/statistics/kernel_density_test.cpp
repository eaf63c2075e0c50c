#include "analysis/statistics/kernel_density.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::analysis {
namespace {

// R: bw.nrd0(x).
TEST(KernelDensity, HasTheBandwidthOfR) {
  EXPECT_NEAR(kernel_density({1, 2, 4, 8, 16}, 2)->bandwidth, 2.9207538685519072, 1e-12);
  EXPECT_NEAR(kernel_density({3, 3, 3, 3, 7}, 2)->bandwidth, 1.166872749618789, 1e-12)
      << "no quartiles apart";
}

// R: h = bw.nrd0(x); sapply(c(1, 8.5, 16), function(at) mean(dnorm(at, x, h)))
TEST(KernelDensity, IsTheMeanOfNormalDensities) {
  const auto found = kernel_density({16, 2, 4, 8, 1}, 3);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->at, (std::vector<double>{1, 8.5, 16}));
  const double expected[] = {0.070745960473917222, 0.039574597801769147, 0.027965732309203396};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found->density[i], expected[i], 1e-14);
}

TEST(KernelDensity, OfOneValueOrOfEqualOnesIsNothing) {
  EXPECT_FALSE(kernel_density({}, 5));
  EXPECT_FALSE(kernel_density({2}, 5));
  EXPECT_FALSE(kernel_density({2, 2, 2}, 5));
}

TEST(KernelDensity, IsFiniteForValuesThatAreNearlyEqual) {
  const auto found = kernel_density({1, std::nextafter(1.0, 2.0), 1, 1}, 9);
  if (!found) return;
  for (const double density : found->density) EXPECT_TRUE(std::isfinite(density));
}

}  // namespace
}  // namespace promenade::analysis
