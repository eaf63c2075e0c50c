#include "analysis/order_effects.h"

#include <gtest/gtest.h>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

class Orders : public ::testing::Test {
 protected:
  // Seconds with the first and with the second interface; labels first where `labels_first`.
  void person(bool labels_first, double first, double second) {
    log.session({"P" + std::to_string(++people)});
    log.trial({labels_first ? "labels" : "weights", "happy", first});
    log.trial({labels_first ? "weights" : "labels", "happy", second});
  }
  OrderEffects effects() {
    const Log read = read_log(log.database());
    data = make_dataset(read, select(read, {}));
    return order_effects_of(read, data);
  }
  template <typename List>
  auto of_time(const List& list) {
    List found;
    for (const auto& one : list) {
      if (one.measure == data.measure("time_s")) found.push_back(one);
    }
    return found;
  }
  TestFolder folder;
  ToyLog log{folder.file("a.db")};
  Dataset data;
  int people = 0;
};

// Second minus first: -1, -2, ..., -6, so W+ = 0 and p = 2/64, and the middle of the 21 Walsh
// averages is -3.5; by the sign test p = 2/64, too.
TEST_F(Orders, TestTheSecondTurnAgainstTheFirst) {
  for (int i = 1; i <= 6; ++i) person(i % 2 == 0, 20, 20 - i);
  const auto learning = of_time(effects().learning);
  ASSERT_EQ(learning.size(), 1u);
  EXPECT_EQ(learning[0].test.n, 6);
  EXPECT_DOUBLE_EQ(*learning[0].p, 2.0 / 64);
  EXPECT_DOUBLE_EQ(learning[0].sign.two, 2.0 / 64);
  EXPECT_DOUBLE_EQ(*learning[0].hl, -3.5);
}

// Values 10, 13, 10 at turns 1, 2, 3 have the slope 0; 10, 11, 18 have (18 - 10) / 2.
TEST_F(Orders, HaveTheSlopeOfLeastSquares) {
  for (const auto& [second, third] : {std::pair{13.0, 10.0}, {11.0, 18.0}}) {
    log.session({"P" + std::to_string(++people)}).trial({"labels", "happy", 10});
    log.trial({"weights", "happy", second}).trial({"map", "happy", third});
  }
  EXPECT_EQ(of_time(effects().learning)[0].slopes, (std::vector<double>{0, 4}));
}

TEST_F(Orders, SummariseEachTurnWhateverTheInterface) {
  person(true, 30, 10);
  person(false, 40, 20);
  const auto turns = of_time(effects().turns);
  ASSERT_EQ(turns.size(), 2u);
  EXPECT_EQ(*turns[0].moments.mean, 35);
  EXPECT_EQ(*turns[1].moments.mean, 15);
}

TEST_F(Orders, TellTheInterfaceBefore) {
  person(true, 30, 10);
  person(true, 32, 12);
  person(false, 40, 20);
  int seen = 0;
  for (const CarryOver& one : of_time(effects().carry_over)) {
    if (data.interfaces.at(static_cast<std::size_t>(one.interface)) != "weights") continue;
    ++seen;
    EXPECT_EQ(*one.moments.mean, one.previous < 0 ? 40 : 11);
    EXPECT_EQ(one.moments.n, one.previous < 0 ? 1 : 2);
  }
  EXPECT_EQ(seen, 2);
}

TEST_F(Orders, CountTurnsAndSuccessions) {
  person(true, 1, 1);
  person(true, 1, 1);
  person(false, 1, 1);
  const OrderEffects order = effects();
  EXPECT_EQ(order.turn_counts[0].at_turn, (std::vector<int>{1, 2})) << "weights";
  EXPECT_EQ(order.turn_counts[1].at_turn, (std::vector<int>{2, 1})) << "labels";
  EXPECT_EQ(order.successions[0].people, 1) << "weights, then labels";
  EXPECT_EQ(order.successions[1].people, 2);
}

TEST_F(Orders, SayWhetherTheyAreBalanced) {
  person(true, 1, 1);
  person(false, 1, 1);
  EXPECT_NE(effects().sentences.at(0).find("are balanced"), std::string::npos);
  person(true, 1, 1);
  EXPECT_NE(effects().sentences.at(0).find("as balanced as 3 people allow"), std::string::npos);
  person(true, 1, 1);
  EXPECT_NE(effects().sentences.at(0).find("not balanced"), std::string::npos);
}

TEST_F(Orders, SayThatOneOrderForAllConfoundsLearning) {
  person(true, 1, 1);
  person(true, 1, 1);
  EXPECT_NE(effects().sentences.at(0).find("same order"), std::string::npos);
}

TEST_F(Orders, OfOneInterfaceHaveNothingToBalance) {
  log.session({}).trial({});
  const OrderEffects order = effects();
  EXPECT_NE(order.sentences.at(0).find("one interface"), std::string::npos);
  EXPECT_EQ(order.learning[0].test.n, 0);
}

TEST_F(Orders, OfOnePersonHaveNothingToBalance) {
  person(true, 1, 1);
  EXPECT_EQ(effects().sentences.at(0), "One person has one order: there is nothing to balance.");
}

// The map is not of this task: it cannot stand at a place of it.
TEST_F(Orders, OfATaskAreThoseOfItsInterfaces) {
  person(true, 1, 1);
  log.trial({"map", "tired", 1, {}, "done", "find"});
  person(false, 1, 1);
  log.trial({"map", "tired", 1, {}, "done", "find"});
  const auto sentences = effects().sentences;
  EXPECT_NE(sentences.at(0).find("In task match the orders are balanced"), std::string::npos);
  EXPECT_NE(sentences.at(1).find("In task find there is one interface"), std::string::npos);
}

}  // namespace
}  // namespace promenade::analysis
