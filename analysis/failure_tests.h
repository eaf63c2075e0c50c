// Do people fail more often with one interface than with another? For each target by yes and
// no, and over a task by the share of each participant, which is the honest aggregate: trials
// of one person are not independent.
#pragma once

#include <vector>

#include "analysis/comparisons.h"
#include "analysis/dataset.h"
#include "analysis/statistics/cochran_q.h"
#include "analysis/statistics/mcnemar.h"

namespace promenade::analysis {

// Of the people who tried the target with both. The first trial of a person counts.
struct FailurePair {
  int task = 0, target = 0, a = 0, b = 0;
  int both = 0, only_a = 0, only_b = 0, neither = 0;  // who failed
  McNemarTest test = {};
  double p_holm = 1;  // of the exact p, over the pairs of this target
  int family = 0;     // how many they are

  int n() const { return both + only_a + only_b + neither; }
};

// Of the people who tried the target with all interfaces that it was tried with.
struct FailureOmnibus {
  int task = 0, target = 0;
  std::vector<int> interfaces;  // at least two
  CochranTest test;             // columns as `interfaces`; n at least 1
};

struct FailureTests {
  std::vector<Comparison> shares;  // measure -1; failed / trials of a participant, per task
  std::vector<FailurePair> pairs;
  std::vector<FailureOmnibus> omnibus;
};

// Of tasks in which a trial can fail: that have a limit or a threshold, or a failure.
FailureTests failure_tests(const Dataset& data);

// Can its trials fail?
bool can_fail(const Dataset& data, int task);

}  // namespace promenade::analysis
