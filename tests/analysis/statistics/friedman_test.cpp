#include "analysis/statistics/friedman.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/cochran_q.h"

namespace promenade::analysis {
namespace {

using Rows = std::vector<std::vector<double>>;

// Chi-square is at least as large in so many of the k!^n equally likely arrangements.
double by_brute_force(Rows rows, std::size_t subject, double chi2) {
  if (subject == rows.size()) return *friedman(rows).chi2 >= chi2 - 1e-9 ? 1 : 0;
  const std::vector<double> given = rows[subject];
  std::vector<std::size_t> order = {0, 1, 2};
  double sum = 0;
  do {
    for (std::size_t i = 0; i < order.size(); ++i) rows[subject][i] = given[order[i]];
    sum += by_brute_force(rows, subject + 1, chi2) / 6;
  } while (std::next_permutation(order.begin(), order.end()));
  return sum;
}

TEST(Friedman, HasTheExactPOfAllArrangements) {
  const Rows rows = {{5, 6, 4}, {5, 5, 7}, {1, 2, 2}, {3, 6, 7}, {4, 4, 4}};
  const FriedmanTest test = friedman(rows);
  EXPECT_NEAR(*test.p_exact, by_brute_force(rows, 0, *test.chi2), 1e-12);
}

// All n agree on the order of three: chi-square is 2n, p = exp(-n), W = 1.
TEST(Friedman, IsLargestWhereAllAgree) {
  const FriedmanTest test = friedman(Rows(5, {3.0, 1.0, 2.0}));
  EXPECT_EQ(test.mean_ranks, (std::vector<double>{3, 1, 2}));
  EXPECT_NEAR(*test.chi2, 10, 1e-12);
  EXPECT_NEAR(*test.p, std::exp(-5.0), 1e-14);
  EXPECT_EQ(test.kendall_w, 1);
  EXPECT_FALSE(test.f);
  EXPECT_EQ(test.p_f, 0);
  EXPECT_NEAR(*test.p_exact, 6 / std::pow(6, 5), 1e-14);
}

TEST(Friedman, OfYesAndNoIsCochransTest) {
  const CochranTest cochran = cochran_q(
      {{true, false, false}, {true, true, false}, {true, false, true}, {true, false, false}});
  const FriedmanTest test = friedman({{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 0, 0}});
  EXPECT_NEAR(*test.chi2, *cochran.q, 1e-12);
  EXPECT_NEAR(*test.p_exact, *cochran.p_exact, 1e-12);
}

TEST(Friedman, IsUndefinedWhereNobodyDiffers) {
  const FriedmanTest test = friedman({{1, 1, 1}, {2, 2, 2}});
  EXPECT_FALSE(test.chi2);
  EXPECT_FALSE(test.f);
  EXPECT_NEAR(*test.p_exact, 1, 1e-15);
}

// The range of two normals is |N(0, 2)|; 3.314493 is the 5 % point for three of tables.
TEST(RangeTail, HasTheValuesOfClosedFormAndTables) {
  for (const double q : {0.0, 0.5, 2.0, 5.0}) {
    EXPECT_NEAR(range_tail(q, 2), std::erfc(q / 2), 1e-13) << q;
  }
  EXPECT_NEAR(range_tail(3.314493, 3), 0.05, 1e-6);
}

}  // namespace
}  // namespace promenade::analysis
