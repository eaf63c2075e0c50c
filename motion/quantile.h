// Order statistics of a few numbers.
#pragma once

#include <vector>

namespace promenade::motion {

// The quantile (0 to 1) of at least one value, linear between order statistics (R's
// type 7, Excel, NumPy).
double quantile(std::vector<double> values, double share);
// The same of values that are sorted already.
double quantile_of_sorted(const std::vector<double>& sorted, double share);

}  // namespace promenade::motion
