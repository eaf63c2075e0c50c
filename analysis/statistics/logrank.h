// The log-rank test (Mantel 1966; for more than two groups Peto & Peto 1972): do people take
// equally long under several conditions, where some were stopped before they were done?
//
// Rule: people who worked under several conditions are strata of their own. Without strata
// their times would count as those of different people.
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/kaplan_meier.h"

namespace promenade::analysis {

struct GroupedDuration {
  Duration duration;
  int group = 0;    // the condition, 0 .. groups - 1
  int stratum = 0;  // the participant; the same for all: not stratified
};

// At every time at which d of the n at risk in a stratum are done, a group with n_i at risk
// expects d n_i / n, with the hypergeometric covariances
//   d (n - d) / (n - 1) n_i / n (delta_ij - n_j / n).
struct LogRankTest {
  std::vector<double> observed, expected;     // how many are done, by group
  std::vector<std::vector<double>> variance;  // groups x groups
  int df = 0;                                 // groups - 1
  // (O - E)' V^-1 (O - E) over all groups but the last, and its p by chi-square with df
  // degrees of freedom. Nothing where V has no inverse: nobody was done, or a group was never
  // at risk beside another one.
  std::optional<double> chi2, p;
};

// Those who are done at a time come before those who are stopped then.
LogRankTest logrank(std::vector<GroupedDuration> durations, int groups);

}  // namespace promenade::analysis
