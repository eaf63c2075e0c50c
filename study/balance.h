// How well orders are balanced: who came where, and after whom.
#pragma once

#include <vector>

#include "study/plan.h"

namespace promenade::study {

struct Balance {
  Eigen::MatrixXi position;    // interfaces x blocks: how often it came in that block
  Eigen::MatrixXi carry_over;  // interfaces x interfaces: how often row came right before column
  // No count differs by more than one from the others of its table (the diagonal of
  // carry_over apart).
  bool even = true;
};

Balance balance_of(const Study& study, const std::vector<Plan>& plans);

// The interface of each block, in order.
std::vector<int> block_order(const Plan& plan);

}  // namespace promenade::study
