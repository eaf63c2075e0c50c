#include "analysis/statistics/proportion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::analysis {
namespace {

constexpr double z95 = 1.959963984540054;  // 97.5 % point of the normal distribution

TEST(WilsonInterval, EndsWhereTheScoreTestTurns) {
  for (const auto& [x, n] : {std::pair{1, 13}, {7, 13}, {12, 13}, {40, 400}}) {
    const Interval ci = wilson_interval(x, n);
    const double share = static_cast<double>(x) / n;
    for (const double p : {ci.lower, ci.upper}) {
      EXPECT_NEAR(std::abs(share - p) / std::sqrt(p * (1 - p) / n), z95, 1e-9);
    }
  }
}

TEST(WilsonInterval, TouchesTheEndsExactly) {
  EXPECT_EQ(wilson_interval(0, 13).lower, 0);
  EXPECT_EQ(wilson_interval(13, 13).upper, 1);
  EXPECT_EQ(wilson_interval(0, 0).lower, 0);
  EXPECT_EQ(wilson_interval(0, 0).upper, 1);
}

// [N] 14 of 17 preferred the map: 95 % [0.566, 0.962].
TEST(ClopperPearsonInterval, OfFourteenOfSeventeenIsAsComputedForTheSource) {
  const Interval ci = clopper_pearson_interval(14, 17);
  EXPECT_NEAR(ci.lower, 0.566, 0.0005);
  EXPECT_NEAR(ci.upper, 0.962, 0.0005);
}

TEST(ClopperPearsonInterval, OfNoneHasTheClosedForm) {
  const Interval ci = clopper_pearson_interval(0, 13);
  EXPECT_EQ(ci.lower, 0);
  EXPECT_NEAR(ci.upper, 1 - std::pow(0.025, 1.0 / 13), 1e-14);
}

}  // namespace
}  // namespace promenade::analysis
