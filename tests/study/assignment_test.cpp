#include "study/assignment.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "study/rng.h"

namespace promenade::study {
namespace {

using State = GivenOrder::State;

constexpr DesignRound four{.rows = 4, .cells = 4};

TEST(NextOrders, CountsUpWhenEveryoneFinishes) {
  EXPECT_EQ(next_orders({}, four, 6), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(next_orders({{0}, {1}, {2}, {3}}, four, 2), (std::vector<int>{4, 5}));
}

TEST(NextOrders, GivesTheOrderOfThoseWhoDoNotCountAgain) {
  EXPECT_EQ(next_orders({{0}, {1, State::gone}, {2}}, four, 1), std::vector<int>{1});
}

TEST(NextOrders, ExpectsThatThoseWhoRunWillCount) {
  EXPECT_EQ(next_orders({{0}, {1, State::runs}, {2}}, four, 1), std::vector<int>{3});
}

// The lowest free number would be 1, whose order others have had twice.
TEST(NextOrders, PutsTheMissingOrderBeforeTheLowestNumber) {
  EXPECT_EQ(next_orders({{0}, {5}, {9}, {2}}, four, 1), std::vector<int>{3});
  EXPECT_EQ(next_orders({{0}, {5}, {9}, {2}, {3}}, four, 1), std::vector<int>{4});
}

TEST(NextOrders, KeepsTheNumberOfAnInterruptedSessionForItsResume) {
  EXPECT_EQ(next_orders({{0, State::interrupted}, {1}, {2}, {3}}, four, 1), std::vector<int>{4});
}

// Rows 2 and 3 are missing, whatever the lists.
TEST(NextOrders, BalancesOrdersBeforeNumbersWithinARoundWithLists) {
  const DesignRound round{.rows = 4, .cells = 16};
  EXPECT_EQ(next_orders({{0}, {1}, {4}, {5}}, round, 2), (std::vector<int>{2, 3}));
}

// 6 is the lowest number of that order of the interfaces, but its lists were given before.
TEST(NextOrders, FillsTheMissingListsOfAnOrder) {
  const DesignRound round{.rows = 2, .cells = 4};
  const std::vector<GivenOrder> given = {
      {0, State::interrupted}, {4, State::interrupted}, {1}, {2}, {3}};
  EXPECT_EQ(next_orders(given, round, 1), std::vector<int>{8});
}

TEST(NextOrders, HasNoOrderWhereThereIsNoDesign) {
  EXPECT_EQ(next_orders({{0}, {1, State::gone}, {3}}, {}, 3), (std::vector<int>{1, 2, 4}));
}

// People come, finish, stop, withdraw and are excluded by lot.
TEST(NextOrders, StaysBalancedWhateverBecomesOfPeople) {
  const DesignRound round{.rows = 6, .cells = 12};
  Rng rng(3, 0, "people");
  std::vector<GivenOrder> given;
  for (int i = 0; i < 600; ++i) {
    given.push_back({next_orders(given, round, 1).front(), State::counts});
    if (rng.below(3) == 0) given[rng.below(given.size())].state = State::gone;
  }
  // Holes that the last withdrawals made are filled by as many people.
  for (int i = 0; i < 200; ++i) given.push_back({next_orders(given, round, 1).front()});
  std::map<int, int> cells;
  std::set<int> numbers;
  for (const GivenOrder& one : given) {
    if (one.state == State::gone) continue;
    ++cells[one.sequence % round.cells];
    EXPECT_TRUE(numbers.insert(one.sequence).second) << one.sequence;
  }
  int least = 1000;
  int most = 0;
  for (const auto& [cell, count] : cells) {
    least = std::min(least, count);
    most = std::max(most, count);
  }
  EXPECT_EQ(cells.size(), 12U);
  EXPECT_LE(most - least, 1);
}

}  // namespace
}  // namespace promenade::study
