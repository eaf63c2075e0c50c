#include "study/repeats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "study/plan.h"
#include "study/split.h"
#include "toy.h"

namespace promenade::study {
namespace {

std::vector<int> counted(int n) {
  std::vector<int> values(static_cast<std::size_t>(n));
  std::iota(values.begin(), values.end(), 0);
  return values;
}

// How many motions stand between the two showings of each that comes twice.
std::vector<int> gaps(const std::vector<Showing>& all) {
  std::map<int, int> first;
  std::vector<int> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int place = static_cast<int>(i);
    if (all[i].showing == 2) found.push_back(place - first.at(all[i].target) - 1);
    if (all[i].showing == 1) first[all[i].target] = place;
  }
  return found;
}

TEST(Repeats, ComeOnceMoreWithThreeMotionsBetween) {
  for (int n = 5; n <= 30; ++n) {
    for (int repeats = 0; repeats <= n / 2; ++repeats) {
      Rng rng(static_cast<std::uint64_t>(100 * n + repeats), 0, "repeats");
      std::vector<int> order = counted(n);
      rng.shuffle(order);
      std::vector<int> again = order;
      rng.shuffle(again);
      again.resize(static_cast<std::size_t>(repeats));
      const std::vector<Showing> all = with_repeats(order, again, false);
      ASSERT_EQ(all.size(), static_cast<std::size_t>(n + repeats));
      std::set<int> seconds;
      for (const Showing& one : all) {
        if (one.showing == 2) seconds.insert(one.target);
      }
      EXPECT_EQ(seconds, std::set<int>(again.begin(), again.end()));
      for (const int gap : gaps(all)) EXPECT_GE(gap, 3) << n << " motions, " << repeats;
    }
  }
}

TEST(Repeats, AreSpreadAsFarAsFewMotionsAllow) {
  EXPECT_EQ(gaps(with_repeats({0, 1, 2}, {2}, false)), std::vector<int>{2});
  EXPECT_EQ(gaps(with_repeats({0}, {0}, false)), std::vector<int>{0});
  EXPECT_EQ(gaps(with_repeats({0, 1, 2, 3}, {0, 1, 2, 3}, false)), (std::vector<int>{3, 3, 3, 3}));
}

TEST(Repeats, StandAmongTheLastNewMotions) {
  const std::vector<Showing> all = with_repeats(counted(10), {0, 5}, false);
  EXPECT_EQ(all[8].showing, 1);
  EXPECT_EQ(all[9].showing, 2);
  EXPECT_EQ(all[10].showing, 1);
  EXPECT_EQ(all[11].showing, 2);
}

TEST(Repeats, LeaveAFixedOrderAsItIs) {
  const std::vector<Showing> all = with_repeats({3, 1, 2, 0}, {0, 3}, true);
  std::vector<int> targets;
  for (const Showing& one : all) targets.push_back(one.target);
  EXPECT_EQ(targets, (std::vector<int>{3, 1, 2, 0, 3, 0}));
}

TEST(Repeats, OfEveryMotionAreEquallyOftenOverARound) {
  for (const auto& [n, k, repeats] : {std::tuple{10, 10, 2}, {27, 10, 2}, {12, 8, 3}}) {
    Rng rng(1, 0, "split");
    const SplitDesign split = make_split(n, k, rng);
    std::map<int, int> count;
    for (int i = 0; i < round_of_pairs(split); ++i) {
      const std::vector<int> again = repeated_of(split, repeats, i);
      EXPECT_EQ(std::set<int>(again.begin(), again.end()).size(), again.size());
      for (const int motion : again) ++count[motion];
    }
    EXPECT_EQ(count.size(), static_cast<std::size_t>(n));
    for (const auto& one : count) EXPECT_EQ(one.second, repeats) << n;
  }
}

std::string text_with(const std::string& keys) {
  return "[study]\nname = 'twice'\n[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = "
         "'impression'\ntargets = [{example = 'far'}, {example = 'near'}, {example = 'side'}]\n" +
         keys;
}

TEST(RepeatedTargets, AreTheSameTaskAndTargetLater) {
  const Study study = toy::bundle(text_with("repeats = 1\n")).study;
  const Plan plan = make_plan(study, 0);
  ASSERT_EQ(plan.trials.size(), 4U);
  EXPECT_EQ(plan.trials[3].showing, 2);
  EXPECT_EQ(plan.trials[3].target, plan.trials[0].target);
  EXPECT_EQ(plan.trials[3].position, 4);
  EXPECT_EQ(make_plan(toy::bundle(text_with("repeats = 0\n")).study, 0).trials.size(), 3U);
}

TEST(RepeatedTargets, AreRefusedBeyondWhatAPersonRates) {
  for (const char* keys :
       {"repeats = 4\n", "each = 2\nrepeats = 3\n", "repeats = -1\n", "repeats = 'two'\n"}) {
    EXPECT_THROW(toy::bundle(text_with(keys)), InputError) << keys;
  }
  EXPECT_NO_THROW(toy::bundle(text_with("each = 2\nrepeats = 2\n")));
}

}  // namespace
}  // namespace promenade::study
