// Intraclass correlations (Shrout & Fleiss 1979): how far do raters agree about the same
// targets, or one person's repeated answers with each other?
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

// Nothing where it is divided by zero: one target, one rater, no variance. What rounding
// leaves of a mean square of zero is zero.
struct Icc {
  int n = 0, k = 0;  // targets and raters
  // Mean squares between targets and raters, of the rest, and within targets.
  std::optional<double> ms_rows, ms_cols, ms_error, ms_within;
  // Of one rater, and of the mean of k.
  std::optional<double> one_way, one_way_mean;          // ICC(1,1), (1,k): other raters each time
  std::optional<double> agreement, agreement_mean;      // (2,1), (2,k): raters random, crossed
  std::optional<double> consistency, consistency_mean;  // (3,1), (3,k): just these raters
  std::optional<double> f_rows, p_rows;                 // ms_rows / ms_error; n-1, (n-1)(k-1)
  // 95 % intervals of the agreement (McGraw & Wong 1996, Satterthwaite's degrees of freedom);
  // that of the mean by Spearman and Brown.
  std::optional<Interval> interval, interval_mean;
};

// x[target][rater], finite, at least one of each, rows of equal length.
Icc icc(const std::vector<std::vector<double>>& x);

}  // namespace promenade::analysis
