#include "analysis/statistics/mcnemar.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::analysis {
namespace {

// 10 and 3: sum over k <= 3 of C(13, k) is 378, C(13, 3) is 286; 2^13 = 8192.
TEST(McNemar, CountsOnlyThoseWhoChanged) {
  const McNemarTest test = mcnemar(10, 3);
  EXPECT_NEAR(test.p_exact, 2 * 378.0 / 8192, 1e-14);
  EXPECT_NEAR(test.p_mid, (2 * 378.0 - 286) / 8192, 1e-14);
  EXPECT_NEAR(*test.chi2, 49.0 / 13, 1e-14);
  EXPECT_NEAR(*test.chi2_corrected, 36.0 / 13, 1e-14);
}

TEST(McNemar, DoesNotDependOnWhichComesFirst) {
  for (int b = 0; b < 8; ++b) {
    for (int c = 0; c < b; ++c) {
      EXPECT_NEAR(mcnemar(b, c).p_mid, mcnemar(c, b).p_mid, 1e-14);
      EXPECT_EQ(mcnemar(b, c).p_chi2, mcnemar(c, b).p_chi2);
    }
  }
}

// Chi-square with one degree is a squared normal: 1.959963984540054 leaves 5 %.
TEST(McNemar, IsTheSquareOfANormalDeviation) {
  const double z = 10 / std::sqrt(26.0);  // 18 and 8
  EXPECT_NEAR(*mcnemar(18, 8).p_chi2, std::erfc(z / std::sqrt(2.0)), 1e-15);
  EXPECT_GT(*mcnemar(18, 8).p_chi2, 0.0498);
  EXPECT_LT(*mcnemar(18, 8).p_chi2, 0.0500);
}

TEST(McNemar, OfEqualCountsNeverDiffers) {
  EXPECT_EQ(mcnemar(2, 2).p_exact, 1);
  EXPECT_NEAR(mcnemar(2, 2).p_mid, 1 - 6.0 / 16, 1e-15);
  EXPECT_EQ(*mcnemar(2, 2).chi2_corrected, 0);
}

TEST(McNemar, HasNoChiSquareWhenNobodyChanged) {
  EXPECT_EQ(mcnemar(0, 0).p_exact, 1);
  EXPECT_FALSE(mcnemar(0, 0).chi2);
}

}  // namespace
}  // namespace promenade::analysis
