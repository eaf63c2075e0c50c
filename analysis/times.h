// How long it took, where a trial that failed (time limit, or given up) only says that it would
// have taken longer: it is right-censored at its end. A look from another side at the times
// that comparisons.h compares, not in their place: these curves take the trials of a person
// for independent, which they are not.
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset.h"
#include "analysis/statistics/kaplan_meier.h"
#include "analysis/statistics/logrank.h"
#include "analysis/statistics/survival_median.h"

namespace promenade::analysis {

// All trials of a task with one interface.
struct TimeCurve {
  int interface = 0;
  int trials = 0, done = 0;  // the others are censored
  Survival survival;         // seconds
  MedianTimeInterval median_ci;
  RestrictedMean restricted;  // to TaskTimes::horizon
};

struct TimePair {
  int a = 0, b = 0;  // interfaces
  LogRankTest test;  // groups: a, b
  std::optional<double> p_holm;
  int family = 0;  // how many pairs have a p
};

struct TaskTimes {
  int task = 0;
  double horizon = 0;     // seconds: the limit of the task, or how far all curves are known
  bool to_limit = false;  // which of the two
  std::vector<TimeCurve> curves;
  LogRankTest test;  // all of them, groups as `curves`, stratified by participant
  std::vector<TimePair> pairs;
};

// For each task with a time.
std::vector<TaskTimes> task_times(const Dataset& data);

}  // namespace promenade::analysis
