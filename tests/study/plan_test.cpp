#include "study/plan.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "study/balance.h"
#include "toy.h"

namespace promenade::study {
namespace {

Study study_of(int interfaces, Order order) {
  Study study;
  study.order = order;
  Task task;
  for (int i = 0; i < interfaces; ++i) {
    study.interfaces.push_back({std::to_string(i), "pick", {}, nullptr});
    task.interfaces.push_back(i);
  }
  task.targets.resize(4);
  task.practice.resize(1);
  study.tasks = {task};
  return study;
}

Balance balance_after(const Study& study, int sessions) {
  std::vector<Plan> plans;
  for (int i = 0; i < sessions; ++i) plans.push_back(make_plan(study, i));
  return balance_of(study, plans);
}

TEST(WilliamsDesign, IsBalancedForPositionAndCarryOver) {
  for (int n = 2; n <= 8; ++n) {
    const int rows = static_cast<int>(williams_design(n).size());
    EXPECT_EQ(rows, n % 2 == 0 ? n : 2 * n);
    const Balance balance = balance_after(study_of(n, Order::williams), rows);
    EXPECT_TRUE((balance.position.array() == rows / n).all()) << n;
    const Eigen::MatrixXi expected =
        (rows / n) * (Eigen::MatrixXi::Ones(n, n) - Eigen::MatrixXi::Identity(n, n));
    EXPECT_EQ(balance.carry_over, expected) << n;
  }
}

TEST(WilliamsDesign, KnowsTheSmallestCases) {
  EXPECT_EQ(williams_design(1), (std::vector<std::vector<int>>{{0}}));
  EXPECT_EQ(williams_design(2), (std::vector<std::vector<int>>{{0, 1}, {1, 0}}));
  EXPECT_EQ(williams_design(4)[0], (std::vector<int>{0, 1, 3, 2}));
}

TEST(LatinSquare, HasEveryConditionOnceInEveryRowAndColumn) {
  const Balance balance = balance_after(study_of(5, Order::latin), 5);
  EXPECT_TRUE((balance.position.array() == 1).all());
}

TEST(MakePlan, KeepsTheOrderOfTheFileWhenItIsFixed) {
  const Plan plan = make_plan(study_of(3, Order::fixed), 4);
  EXPECT_EQ(block_order(plan), (std::vector<int>{0, 1, 2}));
  for (int i = 0; i < 4; ++i) EXPECT_EQ(plan.trials[static_cast<std::size_t>(1 + i)].target, i);
}

TEST(MakePlan, IsTheSameForTheSameSequence) {
  const Study study = study_of(4, Order::random);
  const Plan one = make_plan(study, 9);
  const Plan two = make_plan(study, 9);
  EXPECT_EQ(one.seed, two.seed);
  for (std::size_t i = 0; i < one.trials.size(); ++i) {
    EXPECT_EQ(one.trials[i].target, two.trials[i].target);
    EXPECT_EQ(one.trials[i].interface, two.trials[i].interface);
  }
}

// The order of the targets must never change with a release: old databases name it.
TEST(MakePlan, GivesTheOrderThatItAlwaysGave) {
  const Plan plan = make_plan(study_of(2, Order::williams), 3);
  std::vector<int> targets;
  for (const PlannedTrial& trial : plan.trials) targets.push_back(trial.target);
  EXPECT_EQ(targets, (std::vector<int>{0, 3, 1, 2, 0, 0, 0, 2, 1, 3}));
}

TEST(MakePlan, ShufflesTargetsDifferentlyForEveryPerson) {
  std::set<std::vector<int>> orders;
  for (int sequence = 0; sequence < 60; ++sequence) {
    const Plan plan = make_plan(study_of(1, Order::williams), sequence);
    std::vector<int> order;
    for (const PlannedTrial& trial : plan.trials) {
      if (!trial.practice) order.push_back(trial.target);
    }
    orders.insert(order);
  }
  EXPECT_GT(orders.size(), 15U);  // of 24
}

TEST(MakePlan, PutsPracticeBeforeTheTasksOfEachBlock) {
  const Plan plan = make_plan(toy::bundle().study, 1);
  ASSERT_EQ(plan.trials.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(plan.trials[i].practice, i % 3 == 0);
    EXPECT_EQ(plan.trials[i].position, static_cast<int>(i) + 1);
    EXPECT_EQ(plan.trials[i].block, i < 3 ? 1 : 2);
    EXPECT_EQ(plan.trials[i].task, i % 3 == 2 ? 1 : 0);
  }
}

TEST(MakePlan, OpensAPageBeforeEveryTrial) {
  const Plan plan = make_plan(toy::bundle().study, 0);
  std::string kinds;
  for (const Page& page : plan.pages) kinds += std::string(to_text(page.kind)) + " ";
  EXPECT_EQ(kinds,
            "welcome consent "
            "instructions trial intro trial questionnaire intro trial questionnaire "
            "instructions trial intro trial questionnaire intro trial questionnaire "
            "thanks ");
}

TEST(MakePlan, LeavesOutInterfacesThatATaskDoesNotUse) {
  Study study = study_of(2, Order::williams);
  study.tasks[0].interfaces = {1};
  for (int sequence : {0, 1}) {
    const Plan plan = make_plan(study, sequence);
    EXPECT_EQ(block_order(plan), std::vector<int>{1});
    EXPECT_EQ(plan.trials.front().block, 1);
  }
}

// Wherever the loop over the interfaces stands, the design is the same.
TEST(BalanceOf, CountsOneTurnOfTheInterfacesWhateverTheNesting) {
  for (const auto& nesting : {std::array{Factor::task, Factor::interface, Factor::target},
                              std::array{Factor::target, Factor::task, Factor::interface}}) {
    Study study = study_of(4, Order::williams);
    study.nesting = nesting;
    const Balance balance = balance_after(study, 4);
    EXPECT_TRUE((balance.position.array() == 1).all());
    EXPECT_TRUE(balance.even);
  }
}

TEST(BalanceOf, LeavesRateTasksOut) {
  Study study = study_of(2, Order::williams);
  Task rate;
  rate.kind = TaskKind::rate;
  rate.targets.resize(2);
  study.tasks.push_back(rate);
  EXPECT_TRUE(balance_after(study, 2).even);
}

TEST(BalanceOf, SeesOrdersThatAreNotEven) {
  EXPECT_TRUE(balance_after(study_of(2, Order::williams), 4).even);
  EXPECT_FALSE(balance_after(study_of(2, Order::fixed), 4).even);
}

TEST(Plan, BreaksStandBetweenBlocksOnly) {
  Study study = study_of(3, Order::fixed);
  study.breaks.after_block = true;
  const Plan plan = make_plan(study, 0);
  std::vector<std::size_t> breaks;
  for (std::size_t i = 0; i < plan.pages.size(); ++i) {
    if (plan.pages[i].kind == PageKind::break_) breaks.push_back(i);
  }
  ASSERT_EQ(breaks.size(), 2U);
  for (const std::size_t at : breaks) {
    EXPECT_EQ(plan.pages[at + 1].kind, PageKind::instructions);
  }
}

}  // namespace
}  // namespace promenade::study
