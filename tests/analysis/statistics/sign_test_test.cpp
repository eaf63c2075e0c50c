#include "analysis/statistics/sign_test.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace promenade::analysis {
namespace {

// Among all 2^n ways in which n coins fall, those with at least / at most `heads`.
SignTest by_brute_force(int heads, int n) {
  int greater = 0;
  int less = 0;
  for (unsigned coins = 0; coins < 1u << n; ++coins) {
    const int up = std::popcount(coins);
    greater += up >= heads ? 1 : 0;
    less += up <= heads ? 1 : 0;
  }
  const double all = 1u << n;
  return {n, std::min(1.0, 2 * std::min(greater, less) / all), greater / all, less / all};
}

TEST(SignTest, CountsTheWaysInWhichCoinsFall) {
  for (int n = 0; n <= 12; ++n) {
    for (int heads = 0; heads <= n; ++heads) {
      const SignTest test = sign_test(heads, n - heads);
      const SignTest brute = by_brute_force(heads, n);
      EXPECT_EQ(test.n, n);
      EXPECT_NEAR(test.two, brute.two, 1e-14) << heads << " of " << n;
      EXPECT_NEAR(test.greater, brute.greater, 1e-14) << heads << " of " << n;
      EXPECT_NEAR(test.less, brute.less, 1e-14) << heads << " of " << n;
    }
  }
}

TEST(SignTest, KeepsTheDigitsOfVerySmallP) {
  EXPECT_NEAR(sign_test(200, 0).two / std::ldexp(1.0, -199), 1, 1e-12);
}

}  // namespace
}  // namespace promenade::analysis
