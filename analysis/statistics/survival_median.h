// The interval of a median time where some were stopped before they were done (Brookmeyer &
// Crowley 1982): all times at which the interval of the survival curve holds 1/2.
#pragma once

#include <optional>

#include "analysis/statistics/kaplan_meier.h"

namespace promenade::analysis {

struct MedianTimeInterval {
  std::optional<double> lower, upper;  // nothing where the curve does not say
};

// 95 %, by the pointwise intervals on the scale of log(-log S), as R's survfit with
// conf.type = "log-log": from the first time at which their lower end is at most 1/2 to the
// first at which their upper end is.
MedianTimeInterval median_time_interval(const Survival& survival);

}  // namespace promenade::analysis
