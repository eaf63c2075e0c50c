#include "study/split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "study/assignment.h"
#include "study/balance.h"
#include "toy.h"

namespace promenade::study {
namespace {

SplitDesign split_of(int motions, int each, std::uint64_t seed = 1) {
  Rng rng(seed, 0, "split");
  return make_split(motions, each, rng);
}

std::vector<int> ratings(const SplitDesign& split, int first, int people) {
  std::vector<int> counts(static_cast<std::size_t>(split.motions()), 0);
  for (int i = first; i < first + people; ++i) {
    for (const int motion : motions_of(split, i)) ++counts[static_cast<std::size_t>(motion)];
  }
  return counts;
}

// How often the rarest and the commonest pair of motions met.
std::pair<int, int> meetings(const SplitDesign& split, int people) {
  const int n = split.motions();
  Eigen::MatrixXi met = Eigen::MatrixXi::Zero(n, n);
  for (int i = 0; i < people; ++i) {
    const std::vector<int> motions = motions_of(split, i);
    for (const int a : motions) {
      for (const int b : motions) ++met(a, b);
    }
  }
  std::pair<int, int> range = {INT32_MAX, 0};
  for (int a = 0; a < n; ++a) {
    for (int b = 0; b < a; ++b) {
      range = {std::min(range.first, met(a, b)), std::max(range.second, met(a, b))};
    }
  }
  return range;
}

TEST(Split, GivesEverybodyAsManyDifferentMotions) {
  for (const auto& [n, k] : {std::pair{27, 10}, {10, 10}, {12, 1}, {9, 6}, {100, 37}}) {
    const SplitDesign split = split_of(n, k);
    for (int i = 0; i < 2 * n; ++i) {
      const std::vector<int> motions = motions_of(split, i);
      EXPECT_EQ(std::set<int>(motions.begin(), motions.end()).size(), static_cast<std::size_t>(k));
      EXPECT_TRUE(std::all_of(motions.begin(), motions.end(),
                              [n = n](int motion) { return motion >= 0 && motion < n; }));
    }
  }
}

TEST(Split, RatesEveryMotionEquallyOftenAfterEachRound) {
  for (int n = 1; n <= 30; ++n) {
    for (int k = 1; k <= n; ++k) {
      const SplitDesign split = split_of(n, k);
      const int round = round_of_ratings(split);
      EXPECT_EQ(round, n / std::gcd(n, k));
      for (int first = 0; first <= 3 * round; first += round) {
        const std::vector<int> counts = ratings(split, first, round);
        EXPECT_EQ(std::set<int>(counts.begin(), counts.end()).size(), 1U) << n << " " << k;
      }
    }
  }
}

// Difference sets: in 7, 13 and 21 places each difference occurs exactly once.
TEST(Split, FindsThePairsThatMeetEquallyOftenWhereTheyExist) {
  for (const auto& [n, k] : {std::pair{7, 3}, {13, 4}, {21, 5}, {11, 5}}) {
    const auto [rarest, commonest] = meetings(split_of(n, k), n);
    EXPECT_EQ(rarest, commonest) << n << " " << k;
    EXPECT_EQ(rarest, k * (k - 1) / (n - 1));
  }
}

TEST(Split, LetsPairsMeetNearlyEquallyOftenElsewhere) {
  for (const auto& [n, k] : {std::pair{27, 10}, {24, 10}, {40, 12}}) {
    const SplitDesign split = split_of(n, k);
    const auto [rarest, commonest] = meetings(split, round_of_pairs(split));
    EXPECT_LE(commonest - rarest, 3) << n << " " << k;
    EXPECT_GE(rarest, 1) << n << " " << k;
  }
}

TEST(Split, StaysNearlyEvenWhereAStudyEndsWithinARound) {
  const SplitDesign split = split_of(27, 10);
  for (int people = 1; people < 27; ++people) {
    const std::vector<int> counts = ratings(split, 0, people);
    const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
    EXPECT_LE(*most - *least, 4) << people;
  }
}

// The same on every machine: what it was when it was written.
TEST(Split, IsTheSameEverywhere) {
  const SplitDesign split = split_of(7, 3);
  EXPECT_EQ(split.block, (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(motions_of(split, 0), (std::vector<int>{3, 2, 5}));
  EXPECT_EQ(split_of(27, 10).block, split_of(27, 10).block);
  EXPECT_NE(split_of(27, 10, 1).motion, split_of(27, 10, 2).motion);
}

TEST(Split, IsFastForManyMotions) {
  const SplitDesign split = split_of(1000, 300);
  EXPECT_EQ(motions_of(split, 999).size(), 300U);
}

std::string text_with(const std::string& keys, const std::string& more = "") {
  return "[study]\nname = 'split'\n" + more +
         "[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = 'impression'\n"
         "targets = [{example = 'far'}, {example = 'near'}, {example = 'side'}]\n" +
         keys;
}

std::string problems_of(const std::string& text) {
  try {
    std::string warnings;
    for (const Problem& one : toy::bundle(text).warnings) warnings += one.message + "\n";
    return warnings;
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(SplitTasks, GiveEachPersonSoManyOfTheTargets) {
  const Study study = toy::bundle(text_with("each = 2\n")).study;
  std::vector<Plan> plans;
  for (int i = 0; i < 3; ++i) plans.push_back(make_plan(study, i));
  for (const Plan& plan : plans) EXPECT_EQ(plan.trials.size(), 2U);
  const Balance balance = balance_of(study, plans);
  EXPECT_EQ(balance.ratings[0], Eigen::Vector3i(2, 2, 2));
  EXPECT_TRUE(balance.even);
  EXPECT_EQ(round_of_design(study), 3);
  EXPECT_FALSE(balance_of(study, {plans[0], plans[0]}).even);
}

TEST(SplitTasks, AreRefusedWhereNobodyCanRateSoMany) {
  for (const char* wrong : {"0", "-1", "4", "1.5", "'all'"}) {
    EXPECT_THROW(toy::bundle(text_with("each = " + std::string(wrong) + "\n")), InputError)
        << wrong;
  }
  EXPECT_NE(problems_of(text_with("each = 4\n")).find("where the task has 3; take 1 to 3"),
            std::string::npos);
}

TEST(SplitTasks, WarnOfNumbersThatRateSomeMotionsMoreOften) {
  EXPECT_NE(problems_of(text_with("each = 2\n", "participants = 4\n"))
                .find("4 people who rate 2 of 3 motions each rate some of the task \"judge\" more "
                      "often than others; 3 or 6 people do not"),
            std::string::npos);
  EXPECT_EQ(problems_of(text_with("each = 2\n", "participants = 6\n")), "");
  EXPECT_EQ(problems_of(text_with("", "participants = 4\n")), "");
}

// Whoever replaces somebody rates the same motions.
TEST(SplitTasks, AreReplacedMotionForMotion) {
  const Study study = toy::bundle(text_with("each = 2\n")).study;
  const std::vector<GivenOrder> given = {
      {0, GivenOrder::State::counts}, {1, GivenOrder::State::gone}, {2, GivenOrder::State::counts}};
  const std::vector<int> next = next_orders(given, round_of(study), 1);
  EXPECT_EQ(motions_of(*study.tasks[0].split, next[0]), motions_of(*study.tasks[0].split, 1));
}

}  // namespace
}  // namespace promenade::study
