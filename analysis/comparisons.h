// Interfaces compared in pairs by the signed-rank test, at three levels: each
// target by itself; all targets of a task averaged per person; and all of them
// pooled as if each were a person of its own, as [O] printed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/dataset.h"
#include "analysis/progress.h"
#include "analysis/statistics/hodges_lehmann.h"
#include "analysis/statistics/interval.h"
#include "analysis/statistics/wilcoxon.h"

namespace promenade::analysis {

enum class Pooling {
  none,          // one target, one value per person
  participants,  // the mean over targets, one value per person
  trials,        // one value per person and target: pseudo-replication
};

struct Comparison {
  int measure = 0, task = 0, a = 0, b = 0;  // indices; differences are a - b
  int target = -1;                          // -1: not one target
  Pooling pooling = Pooling::none;
  int missing = 0;               // people (and targets) with a value for one interface only
  std::vector<double> d;         // the differences
  SignedRankTest test;           // zeros dropped, exact
  std::optional<double> p;       // exact; normal where exact is not feasible; nothing for n = 0
  std::optional<double> p_holm;  // over all pairs of interfaces at this place
  int family = 0;                // how many tests that are
  std::optional<double> hl;      // of all differences, zeros kept
  std::optional<LocationInterval> hl_ci;     // 95 %
  std::optional<Interval> rank_biserial_ci;  // 95 %
};

// Pooled trials are shown for comparison only; beyond so many differences the exact p is not
// worth the time.
inline constexpr std::size_t pooled_limit = 1000;

// Had there been an exact p to take, but for the number of differences?
inline bool is_approximate(const Comparison& one) { return one.p && !one.test.exact; }

using PersonValues = std::vector<std::optional<double>>;  // one for each person

// All pairs of interfaces, whose values these are, at the place that `place` names: tested, and
// adjusted together.
std::vector<Comparison> compare_pairs(const Comparison& place,
                                      const std::vector<PersonValues>& values);

// For every measure that has a value in the task: first the means per person, then
// the pooled trials, then each target (of measures of the process the means alone); within each the
// pairs in the order of the interfaces. Holm's family is the pairs of one measure at one place.
// Throws OutsideError when `progress` stops it.
std::vector<Comparison> compare_all(const Dataset& data, const Progress& progress = {});

// Of one measure in one task the means per person alone.
std::vector<Comparison> compare_participants(const Dataset& data, int measure, int task);

// The p that the report gives: exact; normal where that is not feasible; nothing for n = 0.
std::optional<double> reported_p(const SignedRankTest& test);

}  // namespace promenade::analysis
