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
  Interval wilson;           // 95 %
  Interval clopper_pearson;  // 95 %, exact
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

// The values of one target with one interface, one per person.
struct TargetSummary {
  int measure = 0, task = 0, target = 0, interface = 0;
  int n = 0;  // at least 1
  double mean = 0, median = 0, least = 0, most = 0;
  std::optional<double> sd = {};  // with n - 1; nothing for one person
};

// For every task, measure, target and interface that has a value.
std::vector<TargetSummary> target_summaries(const Dataset& data);

}  // namespace promenade::analysis
