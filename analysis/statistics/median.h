// The median and the interval that belongs to the sign test.
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

// Nothing for no values.
std::optional<double> median_of_sorted(const std::vector<double>& sorted);
std::optional<double> median_of(std::vector<double> values);

// Order statistics c and n+1-c, c the largest with P(Bin(n, 1/2) < c) <= (1 - level)/2
// (Thompson 1936); nothing where there is none (95 %: n <= 5). 0 < level < 1.
std::optional<Interval> median_interval(std::vector<double> values, double level);

}  // namespace promenade::analysis
