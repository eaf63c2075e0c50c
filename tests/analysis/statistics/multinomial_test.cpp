#include "analysis/statistics/multinomial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/sign_test.h"

namespace promenade::analysis {
namespace {

double product_of_factorials(const std::vector<int>& counts) {
  double product = 1;
  for (const int count : counts) product *= std::tgamma(count + 1.0);
  return product;
}

// Every one of the k^n ways in which n people choose.
double by_counting(const std::vector<int>& seen) {
  int n = 0;
  for (const int count : seen) n += count;
  const int k = static_cast<int>(seen.size());
  const int ways = static_cast<int>(std::lround(std::pow(k, n)));
  int as_unlikely = 0;
  for (int way = 0; way < ways; ++way) {
    std::vector<int> counts(seen.size(), 0);
    for (int i = 0, rest = way; i < n; ++i, rest /= k) ++counts[static_cast<std::size_t>(rest % k)];
    // The more each choice is taken alike, the smaller the product and the likelier the counts.
    as_unlikely += product_of_factorials(counts) >= product_of_factorials(seen) * (1 - 1e-9);
  }
  return static_cast<double>(as_unlikely) / ways;
}

TEST(EqualChoices, CountEveryWayToChoose) {
  for (const std::vector<int>& seen : std::vector<std::vector<int>>{{5, 1, 1},
                                                                    {3, 3, 1},
                                                                    {7, 0, 0},
                                                                    {2, 2, 3},
                                                                    {4, 2, 0, 0},
                                                                    {2, 2, 1, 1},
                                                                    {3, 1, 1, 1, 0}}) {
    EXPECT_NEAR(*equal_choices(seen).p_exact, by_counting(seen), 1e-12);
  }
}

TEST(EqualChoices, OfTwoAreTheBinomialTest) {
  EXPECT_NEAR(*equal_choices({14, 3}).p_exact, sign_test(14, 3).two, 1e-14);
}

// chisq.test(c(9, 4, 2)) in R: X-squared = 5.2, p = 0.07427.
TEST(EqualChoices, HavePearsonsChiSquareBeside) {
  const EqualChoices test = equal_choices({9, 4, 2});
  EXPECT_NEAR(test.chi2, 5.2, 1e-14);
  EXPECT_NEAR(test.p_chi2, std::exp(-2.6), 1e-14) << "two degrees of freedom";
}

TEST(EqualChoices, AreNotCountedWhereThatTakesTooLong) {
  EXPECT_FALSE(equal_choices({100, 90, 80, 80, 75, 75}).p_exact);
  EXPECT_TRUE(equal_choices({30, 20, 10, 10, 5, 5}).p_exact);
}

}  // namespace
}  // namespace promenade::analysis
