#include "analysis/statistics/wilcoxon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace promenade::analysis {
namespace {

std::vector<double> one_to(int n) {
  std::vector<double> d(static_cast<std::size_t>(n));
  std::iota(d.begin(), d.end(), 1.0);
  return d;
}

// Midrank of one value among all, by counting.
double midrank(const std::vector<double>& d, std::size_t i, Zeros zeros) {
  double below = 0, same = 0;
  for (const double other : d) {
    if (zeros == Zeros::drop && other == 0) continue;
    below += std::abs(other) < std::abs(d[i]) ? 1 : 0;
    same += std::abs(other) == std::abs(d[i]) ? 1 : 0;
  }
  return below + (same + 1) / 2;
}

// The tails by all 2^n sign vectors of the non-zero ranks.
Tails by_brute_force(const std::vector<double>& d, Zeros zeros) {
  std::vector<double> ranks;
  double w = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (d[i] == 0) continue;
    ranks.push_back(midrank(d, i, zeros));
    w += d[i] > 0 ? ranks.back() : 0;
  }
  const unsigned all = 1u << ranks.size();
  double greater = 0, less = 0;
  for (unsigned signs = 0; signs < all; ++signs) {
    double sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) sum += (signs >> i & 1u) ? ranks[i] : 0;
    greater += sum >= w ? 1.0 / all : 0;
    less += sum <= w ? 1.0 / all : 0;
  }
  return {std::min(1.0, 2 * std::min(greater, less)), greater, less};
}

class WilcoxonOf : public testing::TestWithParam<std::vector<double>> {};

TEST_P(WilcoxonOf, TiesAndZerosHasTheTailsOfAllSignVectors) {
  for (const Zeros zeros : {Zeros::drop, Zeros::pratt}) {
    const Tails expected = by_brute_force(GetParam(), zeros);
    const auto exact = wilcoxon(GetParam(), zeros).exact;
    ASSERT_TRUE(exact);
    EXPECT_NEAR(exact->two, expected.two, 1e-14);
    EXPECT_NEAR(exact->greater, expected.greater, 1e-14);
    EXPECT_NEAR(exact->less, expected.less, 1e-14);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Samples, WilcoxonOf,
    testing::Values(std::vector<double>{3, -1, 2}, std::vector<double>{1, 1, -1, 2, 2, -3},
                    std::vector<double>{0, 0, 1, -2, 2, 2, 5, -5, 7, 0},
                    std::vector<double>{-4, -4, -4, -4, 4}, std::vector<double>{0, 1},
                    std::vector<double>{2, 2, -2, -2},
                    std::vector<double>{1, 2, 3, 4, 5, 6, -7, 8, -9, 10, 11, 12, 12, -12}));

TEST(Wilcoxon, OfOnlyPositiveDifferencesHasTheSmallestPossibleP) {
  for (const int n : {5, 13, 60, 150, 500}) {
    const SignedRankTest test = wilcoxon(one_to(n));
    EXPECT_EQ(test.w_plus, n * (n + 1) / 2.0);
    EXPECT_EQ(test.exact->two, std::ldexp(1.0, 1 - n)) << n;
    EXPECT_EQ(test.exact->less, 1) << n;
    EXPECT_EQ(test.rank_biserial, 1.0);
  }
}

TEST(Wilcoxon, TakesMagnitudesFromTheSmallestToTheLargest) {
  const std::vector<double> d = {1e-300, -1e-200, 1e-12, 1.0, -1e12, 1e300};
  const SignedRankTest test = wilcoxon(d);
  EXPECT_EQ(test.w_plus, 1 + 3 + 4 + 6);
  EXPECT_EQ(test.w_minus, 2 + 5);
  EXPECT_EQ(test.tie_sum, 0);
}

TEST(Wilcoxon, OfOnlyZerosHasNoStatisticAndPOfOne) {
  const SignedRankTest test = wilcoxon({0, 0, 0});
  EXPECT_EQ(test.n_zero, 3);
  EXPECT_EQ(test.exact->two, 1);
  EXPECT_FALSE(test.z || test.normal || test.rank_biserial);
}

TEST(Wilcoxon, OfNothingIsDefined) {
  const SignedRankTest test = wilcoxon({});
  EXPECT_EQ(test.n, 0);
  EXPECT_EQ(test.exact->two, 1);
}

// [O] printed p = .382 for 13 people; W+ = 33 gives it: z = (33 - 45.5)/sqrt(204.75).
TEST(Wilcoxon, WithoutCorrectionIsTheNormalApproximationOfThePaper) {
  const SignedRankTest test = wilcoxon({-1, -2, -3, -4, -5, -6, -7, 8, -9, -10, -11, 12, 13});
  ASSERT_EQ(test.w_plus, 33);
  EXPECT_DOUBLE_EQ(*test.z, -12.5 / std::sqrt(204.75));
  EXPECT_NEAR(test.normal->two, 0.382, 0.0005);
  EXPECT_DOUBLE_EQ(*test.z_corrected, -12.0 / std::sqrt(204.75));
}

TEST(Wilcoxon, ChangesSidesWithTheSigns) {
  const std::vector<double> d = {0, 1, 1, -2, 3, 3, -3, 4};
  std::vector<double> negated = d;
  for (double& value : negated) value = -value;
  const SignedRankTest a = wilcoxon(d);
  const SignedRankTest b = wilcoxon(negated);
  EXPECT_EQ(a.w_plus, b.w_minus);
  EXPECT_EQ(a.exact->greater, b.exact->less);
  EXPECT_EQ(a.exact->two, b.exact->two);
}

TEST(Wilcoxon, OfMoreThanIsFeasibleStillHasTheNormalApproximation) {
  const SignedRankTest test = wilcoxon(one_to(2001));
  EXPECT_FALSE(test.exact);
  EXPECT_TRUE(test.normal);
}

// |d|: 1 1 2 3 3 3, and a zero.
TEST(Wilcoxon, CountsTheDifferencesThatAreTied) {
  const SignedRankTest test = wilcoxon({1, -1, 2, 3, 0, 3, -3});
  EXPECT_EQ(test.n_tied, 5);
  EXPECT_EQ(test.tie_sum, 6 + 24);
}

}  // namespace
}  // namespace promenade::analysis
