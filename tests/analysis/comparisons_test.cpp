#include "analysis/comparisons.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

// One task, two targets, one measure. value(person, interface, target).
template <typename Value>
Dataset dataset(int people, int interfaces, Value value) {
  Dataset data;
  data.measures = {{"time_s", "time", "s", "s", 1, 1}};
  data.tasks = {{"match", {"happy", "old"}, {}, {}}};
  for (int i = 0; i < interfaces; ++i) data.interfaces.push_back("i" + std::to_string(i));
  for (int p = 0; p < people; ++p) {
    data.people.push_back("P" + std::to_string(p));
    for (int i = 0; i < interfaces; ++i) {
      for (int t = 0; t < 2; ++t)
        data.trials.push_back({p, i, 0, t, 1, "done", false, {value(p, i, t)}});
    }
  }
  return data;
}

std::vector<Comparison> at(const std::vector<Comparison>& all, Pooling pooling, int target = -1) {
  std::vector<Comparison> found;
  for (const Comparison& one : all) {
    if (one.pooling == pooling && one.target == target) found.push_back(one);
  }
  return found;
}

// d = -(p+1) for happy and p+1 for old, but 2 (p+1) for the last person's old.
std::optional<double> opposite(int p, int i, int t) {
  if (i == 1) return 100;
  return 100 + (t == 0 ? -1 : p == 7 ? 2 : 1) * (p + 1.0);
}

TEST(Comparisons, StandForEachTargetForMeansAndForAllTrials) {
  const auto all = compare_all(dataset(8, 2, opposite));
  const auto happy = at(all, Pooling::none, 0);
  ASSERT_EQ(happy.size(), 1u);
  EXPECT_EQ(happy[0].test.w_minus, 36) << "eight negative differences";
  EXPECT_EQ(happy[0].p, 2.0 / 256);
  const auto means = at(all, Pooling::participants);
  EXPECT_EQ(means[0].test.n, 8);
  EXPECT_EQ(means[0].test.n_zero, 7) << "the means cancel but for one person";
  const auto pooled = at(all, Pooling::trials);
  EXPECT_EQ(pooled[0].test.n, 16);
  EXPECT_EQ(pooled[0].test.w_plus + pooled[0].test.w_minus, 16 * 17 / 2);
}

TEST(Comparisons, AreAMinusBInTheOrderOfTheInterfaces) {
  const auto all =
      compare_all(dataset(6, 3, [](int p, int i, int) { return std::optional(10.0 * i + p); }));
  const auto means = at(all, Pooling::participants);
  ASSERT_EQ(means.size(), 3u);
  EXPECT_EQ(means[1].a, 0);
  EXPECT_EQ(means[1].b, 2);
  EXPECT_EQ(means[1].hl, -20);
}

// Each pair alone has p = 2/64; Holm over three: 3 p for all (p equal).
TEST(Comparisons, AreAdjustedOverThePairsOfOneMeasure) {
  const auto all =
      compare_all(dataset(6, 3, [](int p, int i, int) { return std::optional(10.0 * i + p); }));
  for (const Comparison& one : at(all, Pooling::participants)) {
    EXPECT_EQ(one.p, 2.0 / 64);
    EXPECT_EQ(one.p_holm, 6.0 / 64);
  }
}

TEST(Comparisons, SayHowManyTestsTheFamilyHas) {
  const auto all = compare_all(dataset(
      6, 4, [](int p, int i, int) { return i == 3 ? std::nullopt : std::optional(10.0 * i + p); }));
  for (const Comparison& one : at(all, Pooling::participants)) EXPECT_EQ(one.family, 3);
}

// Beyond pooled_limit pairs only pooled tests lose their exact p.
TEST(Comparisons, AreApproximateOnlyWherePooledAndMany) {
  std::vector<std::optional<double>> a, b(pooled_limit + 1, 0.0);
  for (std::size_t i = 1; i <= pooled_limit + 1; ++i) a.emplace_back(static_cast<double>(i));
  Comparison place;
  place.pooling = Pooling::trials;
  EXPECT_TRUE(is_approximate(compare_pairs(place, {a, b})[0]));
  place.pooling = Pooling::participants;
  EXPECT_FALSE(is_approximate(compare_pairs(place, {a, b})[0]));
  a.pop_back();
  b.pop_back();
  place.pooling = Pooling::trials;
  EXPECT_FALSE(is_approximate(compare_pairs(place, {a, b})[0]));
}

TEST(Comparisons, LeavePairsThatNobodyHasOutOfTheFamily) {
  const auto all = compare_all(dataset(
      6, 3, [](int p, int i, int) { return i == 2 ? std::nullopt : std::optional(10.0 * i + p); }));
  const auto means = at(all, Pooling::participants);
  EXPECT_EQ(means[0].p_holm, 2.0 / 64);
  EXPECT_EQ(means[1].test.n, 0);
  EXPECT_EQ(means[1].missing, 6);
  EXPECT_FALSE(means[1].p || means[1].p_holm || means[1].hl);
}

TEST(Comparisons, NeedTwoInterfaces) { EXPECT_TRUE(compare_all(dataset(6, 1, opposite)).empty()); }

}  // namespace
}  // namespace promenade::analysis
