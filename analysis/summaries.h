// What each interface gave by itself: failures, and the values of a measure.
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset.h"
#include "analysis/statistics/interval.h"

namespace promenade::analysis {

// Trials that ended without success among those that ended.
struct FailureRatio {
  int task = 0, interface = 0;
  int target = -1;  // -1: all targets
  int failed = 0, timeouts = 0, trials = 0;
  Interval wilson;  // 95 %
};

// For each task all targets together, then each; by interface within. Places
// without a trial are left out.
std::vector<FailureRatio> failure_ratios(const Dataset& data);

// One value per person: the mean over the targets of a task.
struct Summary {
  int measure = 0, task = 0, interface = 0;
  std::vector<std::optional<double>> values;  // one per person
  int n = 0;
  std::optional<double> mean, sd, median;  // sd with n - 1
  std::optional<Interval> median_ci;       // see median_interval, 95 %
};

// For every task, measure and interface that has a value.
std::vector<Summary> summaries(const Dataset& data);

}  // namespace promenade::analysis
