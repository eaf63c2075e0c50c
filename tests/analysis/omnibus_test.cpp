#include "analysis/omnibus.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_dataset.h"

namespace promenade::analysis {
namespace {

using Rows = std::vector<std::vector<std::optional<double>>>;

// One target, a row per person and a column per interface.
std::vector<OmnibusTest> tests_of(const Rows& rows) {
  return omnibus_tests(
      toy_dataset(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()), 1,
                  [&rows](int p, int i, int) {
                    return rows[static_cast<std::size_t>(p)][static_cast<std::size_t>(i)];
                  }));
}

// friedman.test() of R on the same rows; the mean ranks by colMeans of rank().
TEST(Omnibus, AgreesWithRWhereThereAreTies) {
  const auto tests = tests_of({{1.2, 3.4, 2.2}, {2.1, 2.1, 5}, {0.5, 4, 3}, {1, 2, 3}, {7, 6, 9}});
  ASSERT_EQ(tests.size(), 1u);
  const FriedmanTest& test = *tests[0].test;
  EXPECT_NEAR(*test.chi2, 4.52631578947368, 1e-13);
  EXPECT_NEAR(*test.p, 0.104021476668038, 1e-13);
  EXPECT_NEAR(test.mean_ranks[0], 1.3, 1e-15);
  EXPECT_NEAR(test.mean_ranks[2], 2.6, 1e-15);
  EXPECT_EQ(omnibus_p(tests[0]), test.p_exact);
}

TEST(Omnibus, TakesCompleteCasesAndCountsTheOthers) {
  const auto tests = tests_of({{1, 2, 3}, {1, {}, 3}, {{}, {}, {}}, {3, 2, 1}});
  EXPECT_EQ(tests[0].n, 2);
  EXPECT_EQ(tests[0].incomplete, 1) << "who has no value at all was not asked";
}

TEST(Omnibus, LeavesOutAnInterfaceThatNobodyHas) {
  const auto tests = tests_of({{1, {}, 2, 3}, {1, {}, 2, 3}});
  EXPECT_EQ(tests[0].interfaces, (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(tests[0].n, 2);
}

TEST(Omnibus, NeedsThreeInterfaces) { EXPECT_TRUE(tests_of({{1, 2}, {2, 3}}).empty()); }

// 0.1 + 0.2 is not 0.3 for a computer.
TEST(Omnibus, TakesRoundingForTies) {
  const auto tests = tests_of({{0.1 + 0.2, 0.3, 0.5}, {0.1 + 0.2, 0.3, 0.5}});
  EXPECT_EQ(tests[0].test->mean_ranks, (std::vector<double>{1.5, 1.5, 3}));
}

TEST(Omnibus, SaysNothingWhereAllAreEqualOrNobodyIsComplete) {
  EXPECT_FALSE(omnibus_p(tests_of({{1, 1, 1}, {2, 2, 2}})[0]));
  const auto none = tests_of({{1, 1, {}}, {{}, 2, 2}});
  EXPECT_FALSE(none[0].test);
  EXPECT_FALSE(omnibus_p(none[0]));
}

}  // namespace
}  // namespace promenade::analysis
