// Cronbach's alpha (Cronbach 1951): how well do the items of a scale measure one thing?
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

// Nothing where it is divided by zero: one item, one respondent, totals that are all equal;
// `standardized` also where an item has the same answer from all. Totals that differ by no
// more than rounding are equal.
struct CronbachAlpha {
  int n = 0, k = 0;                               // respondents and items
  std::optional<double> alpha;                    // k/(k-1) (1 - sum of variances / that of totals)
  std::optional<Interval> interval;               // Feldt (1965), by F with n-1, (n-1)(k-1)
  std::optional<double> standardized;             // k r/(1 + (k-1) r), r the mean correlation
  std::vector<std::optional<double>> if_dropped;  // without each item; none for less than 3
};

// x[respondent][item], finite, at least one of each, rows of equal length; items that ask for
// the opposite are turned round before. 0 < level < 1.
CronbachAlpha cronbach_alpha(const std::vector<std::vector<double>>& x, double level = 0.95);

}  // namespace promenade::analysis
