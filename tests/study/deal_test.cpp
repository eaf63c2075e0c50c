#include "study/deal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "study/balance.h"
#include "toy.h"

namespace promenade::study {
namespace {

TEST(DealLists, DealsToAndFro) {
  EXPECT_EQ(deal_lists({0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, 2),
            (std::vector<std::vector<int>>{{0, 3, 4}, {1, 2, 5}}));
  EXPECT_EQ(deal_lists({0.6, 0.5, 0.4, 0.3, 0.2, 0.1}, 3),
            (std::vector<std::vector<int>>{{5, 0}, {4, 1}, {3, 2}}));
}

TEST(DealLists, KeepsTheOrderOfEquals) {
  EXPECT_EQ(deal_lists({0, 0, 0, 0}, 2), (std::vector<std::vector<int>>{{0, 3}, {1, 2}}));
}

// Sums of a straight line differ by nothing when every list has an even number of targets.
TEST(DealLists, MakesListsOfEqualDifficulty) {
  std::vector<double> difficulties;
  for (int i = 0; i < 20; ++i) difficulties.push_back(0.25 * i);
  for (const std::vector<int>& list : deal_lists(difficulties, 5)) {
    const double sum = std::accumulate(list.begin(), list.end(), 0.0, [&](double all, int one) {
      return all + difficulties[static_cast<std::size_t>(one)];
    });
    EXPECT_EQ(sum, 4 * 0.25 * 9.5);
  }
}

Study dealt_study(int interfaces, int lists, Order order) {
  Study study;
  study.order = order;
  Task task;
  for (int i = 0; i < interfaces; ++i) {
    study.interfaces.push_back({std::to_string(i), "pick", {}, nullptr});
    if (i >= interfaces - lists) task.interfaces.push_back(i);
  }
  task.targets.resize(static_cast<std::size_t>(2 * lists));
  task.deal = Deal::rotated;
  task.lists = deal_lists(std::vector<double>(task.targets.size(), 0.0), lists);
  study.tasks = {task};
  return study;
}

std::vector<Plan> plans_of(const Study& study, int count) {
  std::vector<Plan> plans;
  for (int i = 0; i < count; ++i) plans.push_back(make_plan(study, i));
  return plans;
}

// Which list a trial's target is in.
int list_in(const Study& study, const PlannedTrial& trial) {
  const auto& lists = study.tasks[0].lists;
  for (std::size_t l = 0; l < lists.size(); ++l) {
    if (std::count(lists[l].begin(), lists[l].end(), trial.target) > 0) return static_cast<int>(l);
  }
  return -1;
}

TEST(RotatedLists, GiveEveryInterfaceOneListAndEveryTargetToOneInterface) {
  const Study study = dealt_study(4, 4, Order::williams);
  for (const Plan& plan : plans_of(study, 16)) {
    std::map<int, std::set<int>> lists;
    std::set<int> targets;
    for (const PlannedTrial& trial : plan.trials) {
      lists[trial.interface].insert(list_in(study, trial));
      EXPECT_TRUE(targets.insert(trial.target).second);
    }
    EXPECT_EQ(targets.size(), 8U);
    for (const auto& [interface, one] : lists) EXPECT_EQ(one.size(), 1U) << interface;
  }
}

// Over one round: interface x list x place are all equally often.
TEST(RotatedLists, MeetEveryInterfaceAtEveryPlaceEquallyOften) {
  for (const Order order : {Order::williams, Order::latin}) {
    for (int n = 2; n <= 7; ++n) {
      for (int lists = 2; lists <= n; ++lists) {
        const Study study = dealt_study(n, lists, order);
        const int round = round_of_design(study);
        std::map<std::tuple<int, int, int>, int> count;
        for (const Plan& plan : plans_of(study, round)) {
          const std::vector<int> order_of_plan =
              (order == Order::latin
                   ? latin_square(n)
                   : williams_design(
                         n))[static_cast<std::size_t>(plan.sequence % rows_of_design(study))];
          for (int place = 0; place < n; ++place) {
            const int interface = order_of_plan[static_cast<std::size_t>(place)];
            if (interface < n - lists) continue;
            ++count[{interface, list_of(study, 0, interface, plan.sequence), place}];
          }
        }
        EXPECT_EQ(count.size(), static_cast<std::size_t>(lists * lists * n));
        for (const auto& one : count) EXPECT_EQ(one.second, count.begin()->second) << n << lists;
      }
    }
  }
}

TEST(RotatedLists, MeetEveryInterfaceWithinAsManyPeopleAsThereAreLists) {
  for (const Order order : {Order::williams, Order::latin, Order::random, Order::fixed}) {
    const Study study = dealt_study(5, 3, order);
    const Balance balance = balance_of(study, plans_of(study, 3));
    EXPECT_EQ(balance.lists[0], Eigen::MatrixXi::Ones(3, 3)) << static_cast<int>(order);
  }
}

TEST(RotatedLists, DifferAlsoWhereATaskLeavesOneInterfaceOut) {
  Study study = dealt_study(3, 2, Order::williams);
  study.tasks[0].interfaces = {0, 2};
  for (int sequence = 0; sequence < 12; ++sequence) {
    EXPECT_NE(list_of(study, 0, 0, sequence), list_of(study, 0, 2, sequence));
  }
}

TEST(RotatedLists, AreCountedByTheBalance) {
  const Study study = dealt_study(2, 2, Order::williams);
  EXPECT_TRUE(balance_of(study, plans_of(study, 4)).even);
  EXPECT_FALSE(balance_of(study, {make_plan(study, 0), make_plan(study, 0)}).even);
}

}  // namespace
}  // namespace promenade::study
