// What [O] plots in its Figures 7, 9 and 10: means over participants, target by target, and the
// mean difference of each interface to one of reference.
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset.h"
#include "analysis/statistics/interval.h"

namespace promenade::analysis {

struct TargetMean {
  int interface = 0;
  int target = -1;  // -1: the mean over targets of each person
  int n = 0;        // participants
  double mean = 0;
  std::optional<double> sd;  // with n - 1
};

// One value per participant at each place; by target, all targets at the end, by interface within.
// Places without a value are left out; so are "all targets" where there is but one.
std::vector<TargetMean> target_means(const Dataset& data, int measure, int task);

struct MeanDifference {
  int interface = 0;
  int target = -1;
  int n = 0;                         // participants with a value of both
  double mean = 0;                   // interface - reference
  std::optional<Interval> interval;  // 90 %, of Student; nothing for one participant
};

std::vector<MeanDifference> mean_differences(const Dataset& data, int measure, int task,
                                             int reference);

// [O] compares with the blend weights: the interface that has "weight" in its name, else the
// last one of the task; -1 where the task has fewer than two.
int reference_interface(const Dataset& data, int task);

}  // namespace promenade::analysis
