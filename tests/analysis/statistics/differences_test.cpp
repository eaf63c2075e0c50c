#include "analysis/statistics/differences.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

TEST(Differences, ThatRoundingToreApartAreTiesAgain) {
  const Differences d = paired_differences({0.3, 0.7, 0.1}, {0.1, 0.5, 0.3});
  ASSERT_NE(0.3 - 0.1, 0.7 - 0.5) << "the premise";
  EXPECT_EQ(d.values[0], d.values[1]);
  EXPECT_EQ(d.values[0], -d.values[2]);
}

TEST(Differences, OfWhatRoundingMadeUnequalAreZero) {
  const Differences d = paired_differences({0.1 + 0.2, 5.0}, {0.3, 1.0});
  EXPECT_EQ(d.values, (std::vector<double>{0, 4}));
}

TEST(Differences, LeaveOutIncompletePairsAndCountThem) {
  const Differences d = paired_differences({1.0, std::nullopt, 4.0}, {2.0, 3.0, std::nullopt});
  EXPECT_EQ(d.values, std::vector<double>{-1});
  EXPECT_EQ(d.missing, 2);
}

TEST(Differences, ThatAreSmallBesideTheValuesStayApart) {
  const Differences d = paired_differences({1000.0, 1000.0}, {999.99999, 999.99998});
  EXPECT_NE(d.values[0], d.values[1]);
  EXPECT_NE(d.values[0], 0);
}

}  // namespace
}  // namespace promenade::analysis
