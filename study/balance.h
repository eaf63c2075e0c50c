// How well orders are balanced: who came where, after whom, and with which list of targets.
#pragma once

#include <vector>

#include "study/plan.h"

namespace promenade::study {

// An order runs through one turn of the loop over the interfaces, whichever loops stand around
// it (Study::nesting): with the interface outermost there is one turn, else each has the same
// order. What comes between two turns is another task or target, and is not counted.
struct Balance {
  Eigen::MatrixXi position;    // interfaces x places: how often it came there
  Eigen::MatrixXi carry_over;  // interfaces x interfaces: how often row came right before column
  // For each task: its interfaces x lists, how often; 0 x 0 where all interfaces get all targets.
  std::vector<Eigen::MatrixXi> lists;
  // For each task with a split design: how many people rate each of its targets, practice and
  // repeats apart; empty where there is none.
  std::vector<Eigen::VectorXi> ratings;
  // No count differs by more than one from the others of its table (the diagonal of
  // carry_over apart).
  bool even = true;
};

Balance balance_of(const Study& study, const std::vector<Plan>& plans);

// The interfaces in the order in which they come. Those of no trial are left out.
std::vector<int> block_order(const Plan& plan);

}  // namespace promenade::study
