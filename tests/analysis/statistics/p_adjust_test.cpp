#include "analysis/statistics/p_adjust.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

void expect_near(const std::vector<double>& actual, const std::vector<double>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-15) << i;
}

TEST(PAdjust, KeepsTheOrderGiven) {
  const std::vector<double> p = {0.03, 0.01, 0.02, 0.5};
  expect_near(adjust_bonferroni(p), {0.12, 0.04, 0.08, 1});
  expect_near(adjust_holm(p), {0.06, 0.04, 0.06, 0.5});
  expect_near(adjust_hochberg(p), {0.06, 0.04, 0.06, 0.5});
  expect_near(adjust_bh(p), {0.04, 0.04, 0.04, 0.5});
  expect_near(adjust_by(p), {0.04 * 25 / 12, 0.04 * 25 / 12, 0.04 * 25 / 12, 1});
}

TEST(PAdjust, TellsHolmAndHochbergApart) {
  const std::vector<double> p = {0.04, 0.03};
  expect_near(adjust_holm(p), {0.06, 0.06});
  expect_near(adjust_hochberg(p), {0.04, 0.04});
}

TEST(PAdjust, LeavesASingleTestAlone) {
  for (const auto adjust : {adjust_holm, adjust_hochberg, adjust_bh, adjust_by}) {
    expect_near(adjust({0.2}), {0.2});
    expect_near(adjust({}), {});
  }
}

}  // namespace
}  // namespace promenade::analysis
