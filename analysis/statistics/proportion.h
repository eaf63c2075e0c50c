// Intervals of a proportion: x successes among n.
#pragma once

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

// The score interval of Wilson 1927, without continuity correction: all p with
// |x/n - p| <= z sqrt(p (1-p) / n). Exactly 0 below for x = 0, exactly 1 above for
// x = n, [0, 1] for n = 0. 0 <= x <= n; level between 0 and 1.
Interval wilson_interval(int x, int n, double level = 0.95);

// The exact interval of Clopper & Pearson 1934 by quantiles of the beta
// distribution; ends as above.
Interval clopper_pearson_interval(int x, int n, double level = 0.95);

}  // namespace promenade::analysis
