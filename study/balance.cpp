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

}  // namespace

std::vector<int> block_order(const Plan& plan) {
  std::vector<int> order;
  int block = 0;
  for (const PlannedTrial& trial : plan.trials) {
    if (trial.block != block) order.push_back(trial.interface);
    block = trial.block;
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
  return balance;
}

}  // namespace promenade::study
