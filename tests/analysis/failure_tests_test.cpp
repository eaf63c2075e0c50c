#include "analysis/failure_tests.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_dataset.h"

namespace promenade::analysis {
namespace {

constexpr double in_time = 10, too_late = 60;

// Six people fail the first target with i0 alone, one with both; nobody the second target.
std::optional<double> first_is_hard(int p, int i, int t) {
  if (t == 1 || p >= 7) return in_time;
  return i == 0 || p == 6 ? too_late : in_time;
}

// 6 of 6 changes in one direction: p = 2/64 by the binomial distribution.
TEST(FailureTests, CountWhoFailedWithJustOne) {
  const FailureTests tests = failure_tests(toy_dataset(9, 2, 2, first_is_hard));
  ASSERT_EQ(tests.pairs.size(), 2u);
  const FailurePair& hard = tests.pairs[0];
  EXPECT_EQ(hard.both, 1);
  EXPECT_EQ(hard.only_a, 6);
  EXPECT_EQ(hard.only_b, 0);
  EXPECT_EQ(hard.neither, 2);
  EXPECT_NEAR(hard.test.p_exact, 2.0 / 64, 1e-15);
  EXPECT_EQ(tests.pairs[1].test.p_exact, 1);
}

// A share of 1/2 against 0 for six people, no difference for the others.
TEST(FailureTests, CompareTheSharesOfParticipants) {
  const FailureTests tests = failure_tests(toy_dataset(9, 2, 2, first_is_hard));
  ASSERT_EQ(tests.shares.size(), 1u);
  const Comparison& one = tests.shares[0];
  EXPECT_EQ(one.test.n, 9);
  EXPECT_EQ(one.test.n_zero, 3);
  EXPECT_EQ(one.test.w_plus, 21);
  EXPECT_EQ(one.p, 2.0 / 64);
  EXPECT_EQ(one.test.n_tied, 6);
}

// For two interfaces Q is McNemar's chi-square: (6 - 0)^2 / 6.
TEST(FailureTests, HaveCochransQForTwoAndMore) {
  const FailureTests two = failure_tests(toy_dataset(9, 2, 2, first_is_hard));
  ASSERT_EQ(two.omnibus.size(), 2u);
  EXPECT_NEAR(*two.omnibus[0].test.q, 6, 1e-12);
  EXPECT_FALSE(two.omnibus[1].test.q) << "nobody failed";
  const FailureTests three = failure_tests(toy_dataset(9, 3, 1, first_is_hard));
  EXPECT_EQ(three.omnibus[0].test.column_totals, (std::vector<int>{7, 1, 1}));
  EXPECT_EQ(three.pairs.size(), 3u);
  EXPECT_NEAR(three.pairs[0].p_holm, 3 * 2.0 / 64, 1e-15);
}

TEST(FailureTests, TakeTheFirstTrialOfWhoTriedTwice) {
  Dataset data = toy_dataset(1, 2, 1, [](int, int, int) { return std::optional(in_time); });
  data.trials.push_back({0, 0, 0, 0, 3, "timeout", true, {too_late}});
  const FailureTests tests = failure_tests(data);
  EXPECT_EQ(tests.pairs[0].neither, 1);
  EXPECT_EQ(tests.shares[0].d, (std::vector<double>{0.5}));
}

TEST(FailureTests, LeaveOutTasksThatCannotFail) {
  Dataset data = toy_dataset(2, 2, 1, [](int, int, int) { return std::optional(in_time); });
  data.tasks[0].limit_s.reset();
  EXPECT_TRUE(failure_tests(data).pairs.empty());
}

TEST(FailureTests, SayNothingWhereNobodyTriedBoth) {
  const FailureTests tests = failure_tests(toy_dataset(4, 2, 1, [](int p, int i, int) {
    return p % 2 == i ? std::optional(in_time) : std::nullopt;
  }));
  EXPECT_TRUE(tests.pairs.empty());
  EXPECT_TRUE(tests.omnibus.empty());
  EXPECT_FALSE(tests.shares[0].p);
}

}  // namespace
}  // namespace promenade::analysis
