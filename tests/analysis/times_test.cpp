#include "analysis/times.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis/toy_dataset.h"

namespace promenade::analysis {
namespace {

// One trial each with two interfaces: in a stratum only the first to be done counts, with
// O - E = 1/2 and V = 1/4. So chi-square is (wins - losses)^2 / (wins + losses): 7 against 2.
TEST(Times, AreComparedWithinPeople) {
  const auto all = task_times(toy_dataset(9, 2, 1, [](int p, int i, int) {
    return std::optional(10.0 + p + ((p < 7) == (i == 0) ? 0 : 20));
  }));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(*all[0].test.chi2, 25.0 / 9, 1e-12);
  EXPECT_NEAR(*all[0].test.p, std::erfc(std::sqrt(25.0 / 9 / 2)), 1e-12);
  ASSERT_EQ(all[0].pairs.size(), 1u);
  EXPECT_EQ(all[0].pairs[0].p_holm, all[0].test.p);
}

// 10, 20, 30, 60+, 60+: S = 4/5, 3/5, 2/5 from 30 on; the area up to 60 is
// 10 + 8 + 6 + 12 = 36, the median 30.
TEST(Times, OfFailuresAreCensored) {
  const auto all = task_times(toy_dataset(
      5, 1, 1, [](int p, int, int) { return std::optional(p < 3 ? 10.0 * (p + 1) : 60.0); }));
  const TimeCurve& curve = all[0].curves[0];
  EXPECT_EQ(curve.trials, 5);
  EXPECT_EQ(curve.done, 3);
  EXPECT_EQ(curve.survival.median, 30);
  EXPECT_NEAR(curve.restricted.mean, 36, 1e-12);
  EXPECT_TRUE(all[0].to_limit);
  EXPECT_EQ(all[0].horizon, 60);
}

TEST(Times, WithoutALimitGoAsFarAsAllAreKnown) {
  Dataset data =
      toy_dataset(2, 2, 1, [](int p, int i, int) { return std::optional(10.0 + 10 * p + 5 * i); });
  data.tasks[0].limit_s.reset();
  const auto all = task_times(data);
  EXPECT_FALSE(all[0].to_limit);
  EXPECT_EQ(all[0].horizon, 20) << "i0 has 10 and 20, i1 has 15 and 25";
  EXPECT_NEAR(all[0].curves[1].restricted.mean, 15 + 0.5 * 5, 1e-12);
}

TEST(Times, SayNothingWhereAllRanOut) {
  const auto all =
      task_times(toy_dataset(5, 3, 2, [](int, int, int) { return std::optional(60.0); }));
  EXPECT_FALSE(all[0].test.p);
  EXPECT_FALSE(all[0].pairs[0].p_holm);
  EXPECT_FALSE(all[0].curves[0].survival.median);
  EXPECT_EQ(all[0].curves[0].restricted.mean, 60);
}

TEST(Times, OfPeopleWithOneInterfaceEachCannotBeCompared) {
  const auto all = task_times(toy_dataset(4, 2, 1, [](int p, int i, int) {
    return p % 2 == i ? std::optional(10.0 + p) : std::nullopt;
  }));
  EXPECT_FALSE(all[0].test.p);
}

}  // namespace
}  // namespace promenade::analysis
