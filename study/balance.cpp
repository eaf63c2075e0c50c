#include "study/balance.h"

#include <algorithm>

namespace promenade::study {
namespace {

bool differ_by_one_at_most(const Eigen::MatrixXi& counts, bool without_diagonal) {
  int least = INT32_MAX;
  int most = INT32_MIN;
  for (Eigen::Index r = 0; r < counts.rows(); ++r) {
    for (Eigen::Index c = 0; c < counts.cols(); ++c) {
      if (without_diagonal && r == c) continue;
      least = std::min(least, counts(r, c));
      most = std::max(most, counts(r, c));
    }
  }
  return most <= least || most - least <= 1;
}

bool is_dealt(const Task& task) { return task.deal == Deal::rotated && !task.lists.empty(); }

// Interfaces x lists of one task; those that do not do it have no row.
Eigen::MatrixXi count_lists(const Study& study, int task, const std::vector<Plan>& plans) {
  const Task& dealt = study.tasks[static_cast<std::size_t>(task)];
  Eigen::MatrixXi counts = Eigen::MatrixXi::Zero(static_cast<Eigen::Index>(dealt.interfaces.size()),
                                                 static_cast<Eigen::Index>(dealt.lists.size()));
  for (const Plan& plan : plans) {
    for (std::size_t i = 0; i < dealt.interfaces.size(); ++i) {
      ++counts(static_cast<Eigen::Index>(i),
               list_of(study, task, dealt.interfaces[i], plan.sequence));
    }
  }
  return counts;
}

Eigen::VectorXi count_ratings(const Task& task, int index, const std::vector<Plan>& plans) {
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(static_cast<Eigen::Index>(task.targets.size()));
  for (const Plan& plan : plans) {
    for (const PlannedTrial& trial : plan.trials) {
      const bool here = trial.task == index && !trial.practice && trial.showing == 1;
      if (here) ++counts(trial.target);
    }
  }
  return counts;
}

}  // namespace

std::vector<int> block_order(const Plan& plan) {
  std::vector<int> order;
  for (const PlannedTrial& trial : plan.trials) {
    const bool known = std::find(order.begin(), order.end(), trial.interface) != order.end();
    if (trial.interface >= 0 && !known) order.push_back(trial.interface);
  }
  return order;
}

Balance balance_of(const Study& study, const std::vector<Plan>& plans) {
  const auto n = static_cast<Eigen::Index>(study.interfaces.size());
  Balance balance;
  balance.position = Eigen::MatrixXi::Zero(n, n);
  balance.carry_over = Eigen::MatrixXi::Zero(n, n);
  for (const Plan& plan : plans) {
    const std::vector<int> order = block_order(plan);
    for (std::size_t i = 0; i < order.size(); ++i) {
      ++balance.position(order[i], static_cast<Eigen::Index>(i));
      if (i > 0) ++balance.carry_over(order[i - 1], order[i]);
    }
  }
  balance.even = differ_by_one_at_most(balance.position, false) &&
                 differ_by_one_at_most(balance.carry_over, true);
  for (std::size_t t = 0; t < study.tasks.size(); ++t) {
    balance.lists.emplace_back();
    balance.ratings.emplace_back();
    if (study.tasks[t].split) {
      balance.ratings.back() = count_ratings(study.tasks[t], static_cast<int>(t), plans);
      balance.even = balance.even && differ_by_one_at_most(balance.ratings.back(), false);
    }
    if (!is_dealt(study.tasks[t])) continue;
    balance.lists.back() = count_lists(study, static_cast<int>(t), plans);
    balance.even = balance.even && differ_by_one_at_most(balance.lists.back(), false);
  }
  return balance;
}

}  // namespace promenade::study
