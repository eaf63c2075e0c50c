#include "analysis/statistics/cochran_q.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/mcnemar.h"

namespace promenade::analysis {
namespace {

using Rows = std::vector<std::vector<bool>>;

// Q is at least as large in so many of the k!^n equally likely arrangements.
double by_brute_force(Rows rows, std::size_t subject, double q) {
  if (subject == rows.size()) return *cochran_q(rows).q >= q - 1e-9 ? 1 : 0;
  const std::vector<bool> given = rows[subject];
  std::vector<std::size_t> order = {0, 1, 2};
  double sum = 0;
  do {
    for (std::size_t i = 0; i < order.size(); ++i) rows[subject][i] = given[order[i]];
    sum += by_brute_force(rows, subject + 1, q) / 6;
  } while (std::next_permutation(order.begin(), order.end()));
  return sum;
}

TEST(CochranQ, HasTheExactPOfAllArrangements) {
  const Rows rows = {{true, false, false}, {true, true, false}, {true, false, false},
                     {true, true, true},   {true, false, true}, {false, false, false}};
  const CochranTest test = cochran_q(rows);
  EXPECT_NEAR(*test.p_exact, by_brute_force(rows, 0, *test.q), 1e-12);
}

// With two conditions Q is McNemar's chi-square: 4 changed one way, 1 the other.
TEST(CochranQ, OfTwoConditionsIsMcNemarsTest) {
  const Rows rows = {{true, false}, {true, false}, {true, false}, {true, false},
                     {false, true}, {true, true},  {false, false}};
  const CochranTest test = cochran_q(rows);
  EXPECT_NEAR(*test.q, *mcnemar(4, 1).chi2, 1e-12);
  EXPECT_NEAR(*test.p, *mcnemar(4, 1).p_chi2, 1e-12);
  EXPECT_NEAR(*test.p_exact, mcnemar(4, 1).p_exact, 1e-12);
}

// All n fail under one of three: Q = 2n, p = exp(-n), and 3 of 3^n choices are as clear.
TEST(CochranQ, IsLargestWhereOneConditionAlwaysFails) {
  const CochranTest test = cochran_q(Rows(9, {false, true, false}));
  EXPECT_EQ(test.column_totals, (std::vector<int>{0, 9, 0}));
  EXPECT_NEAR(*test.q, 18, 1e-12);
  EXPECT_NEAR(*test.p, std::exp(-9.0), 1e-15);
  EXPECT_NEAR(*test.p_exact, std::pow(3, -8), 1e-15);
}

TEST(CochranQ, IsUndefinedWhereNobodyDiffers) {
  const CochranTest test = cochran_q({{true, true, true}, {false, false, false}});
  EXPECT_FALSE(test.q);
  EXPECT_FALSE(test.p);
  EXPECT_NEAR(*test.p_exact, 1, 1e-15);
}

}  // namespace
}  // namespace promenade::analysis
