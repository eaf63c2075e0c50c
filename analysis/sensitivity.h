// Would the conclusions be others with other people or trials? The primary results (final and
// best D, time, ratings; one value per participant) computed again: without flagged trials, with
// the people whom --exclude left out, and for each version of the study alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/comparisons.h"

namespace promenade::analysis {

// One primary result under one choice of people and trials. Its names stand in the data set of
// all that is analysed.
struct SensitivityResult {
  int measure = 0, task = 0, a = 0, b = 0;  // as in Comparison
  int n = 0;
  std::optional<double> hl, p, p_holm;
  std::optional<Interval> hl_ci;  // 95 %
  // As in what the report says: significant at .05 (Holm) with the same sign, or in both not
  // significant. Nothing where there is no value to compare.
  std::optional<bool> same_conclusion;
};

enum class SensitivityKind { all, unflagged, with_excluded, version };

struct SensitivityVariant {
  SensitivityKind kind = SensitivityKind::all;
  std::string name;  // "without flagged trials"
  int people = 0, trials = 0;
  std::vector<SensitivityResult> results;  // the same in all variants, in the same order
};

struct Sensitivity {
  std::vector<SensitivityVariant> variants;  // the first is what the report says
  std::vector<std::string> sentences;        // for the first page; empty: nothing to vary
  int compared = 0;                          // primary results of the report
};

Sensitivity sensitivity_of(const Log& log, const SelectionOptions& options,
                           const Selection& selection, const Dataset& data);

// "P07 and P21"; more than four are "P01, P02, P03, P04 and 7 others".
std::string names_up_to_four(const std::vector<std::string>& names);

}  // namespace promenade::analysis
