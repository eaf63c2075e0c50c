#include "analysis/statistics/logrank.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "study/rng.h"

namespace promenade::analysis {
namespace {

// Two groups by the sums of Mantel, straight from the definition, for each pair of stratum
// and time.
struct TwoGroups {
  double observed = 0, expected = 0, variance = 0;
};

TwoGroups by_definition(const std::vector<GroupedDuration>& all) {
  TwoGroups sums;
  for (const GroupedDuration& now : all) {
    double n = 0, first = 0, d = 0, done_first = 0, same = 0;
    for (const GroupedDuration& other : all) {
      if (other.stratum != now.stratum || other.duration.time < now.duration.time) continue;
      const bool done_now = other.duration.time == now.duration.time && other.duration.done;
      n += 1;
      first += other.group == 0 ? 1 : 0;
      d += done_now ? 1 : 0;
      done_first += done_now && other.group == 0 ? 1 : 0;
      same += other.duration.time == now.duration.time ? 1 : 0;
    }
    sums.observed += done_first / same;  // once for each of those at this time
    sums.expected += d * first / n / same;
    if (n > 1) sums.variance += d * (n - d) / (n - 1) * first / n * (n - first) / n / same;
  }
  return sums;
}

std::vector<GroupedDuration> random_durations(std::uint64_t seed, int groups, int strata) {
  study::Rng rng(seed, 0, "logrank");
  std::vector<GroupedDuration> durations;
  for (int i = 0; i < 60; ++i) {
    const double time = 1 + static_cast<double>(rng.below(12));  // many ties
    durations.push_back({{time, rng.below(4) > 0}, i % groups, (i / groups) % strata});
  }
  return durations;
}

TEST(LogRank, OfTwoGroupsIsTheSumOverTimesAndStrata) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto durations = random_durations(seed, 2, seed % 2 == 0 ? 1 : 7);
    const TwoGroups sums = by_definition(durations);
    const LogRankTest test = logrank(durations, 2);
    EXPECT_NEAR(test.observed[0], sums.observed, 1e-12);
    EXPECT_NEAR(test.expected[0], sums.expected, 1e-12);
    EXPECT_NEAR(test.variance[0][1], -sums.variance, 1e-12);
    const double difference = sums.observed - sums.expected;
    EXPECT_NEAR(*test.chi2, difference * difference / sums.variance, 1e-10);
    EXPECT_NEAR(*test.p, std::erfc(std::sqrt(*test.chi2 / 2)), 1e-12);
  }
}

// Everybody works once under each of two conditions and is always done: the sign test.
TEST(LogRank, StratifiedByPairsComparesSigns) {
  std::vector<GroupedDuration> durations;
  for (int person = 0; person < 9; ++person) {
    const bool first_is_fast = person < 7;
    durations.push_back({{first_is_fast ? 10.0 + person : 200, true}, 0, person});
    durations.push_back({{first_is_fast ? 200 : 10.0 + person, true}, 1, person});
  }
  const LogRankTest test = logrank(durations, 2);
  EXPECT_NEAR(*test.chi2, (7 - 2) * (7 - 2) / 9.0, 1e-12);
  EXPECT_LT(*logrank(durations, 2).p, 0.1);
}

TEST(LogRank, IsTheSameWhicheverGroupComesLast) {
  const auto durations = random_durations(3, 4, 5);
  const LogRankTest test = logrank(durations, 4);
  auto turned = durations;
  for (GroupedDuration& one : turned) one.group = (one.group + 1) % 4;
  EXPECT_NEAR(*logrank(turned, 4).chi2, *test.chi2, 1e-10);
  EXPECT_EQ(test.df, 3);
  const double expected = std::accumulate(test.expected.begin(), test.expected.end(), 0.0);
  EXPECT_NEAR(expected, std::accumulate(test.observed.begin(), test.observed.end(), 0.0), 1e-12);
  for (const auto& row : test.variance) {
    EXPECT_NEAR(std::accumulate(row.begin(), row.end(), 0.0), 0, 1e-12);
  }
}

TEST(LogRank, HasNothingToSayWhereNobodyIsDone) {
  const LogRankTest test = logrank({{{300, false}, 0, 0}, {{300, false}, 1, 0}}, 2);
  EXPECT_EQ(test.observed, (std::vector<double>{0, 0}));
  EXPECT_FALSE(test.chi2 || test.p);
  EXPECT_EQ(test.df, 1);
}

TEST(LogRank, HasNothingToSayOfAGroupThatWasNeverAtRiskBesideAnother) {
  // The third group was stopped before anybody was done; then one that has strata of its own.
  EXPECT_FALSE(logrank({{{9, true}, 0}, {{8, true}, 1}, {{7, true}, 1}, {{1, false}, 2}}, 3).chi2);
  EXPECT_FALSE(logrank({{{9, true}, 0, 1}, {{8, true}, 1, 2}}, 2).chi2);
}

TEST(LogRank, TakesNobodyOnePersonAndOneGroup) {
  EXPECT_TRUE(logrank({}, 0).observed.empty());
  EXPECT_FALSE(logrank({}, 2).chi2);
  EXPECT_EQ(logrank({{{1, true}, 0}}, 1).df, 0);
  EXPECT_FALSE(logrank({{{1, true}, 0}, {{2, true}, 0}}, 1).chi2);
}

TEST(LogRank, LooksAtTheOrderOfTimesOnly) {
  auto durations = random_durations(5, 3, 4);
  const double chi2 = *logrank(durations, 3).chi2;
  for (GroupedDuration& one : durations) one.duration.time = std::pow(10, 20 * one.duration.time);
  EXPECT_EQ(*logrank(durations, 3).chi2, chi2);
}

}  // namespace
}  // namespace promenade::analysis
