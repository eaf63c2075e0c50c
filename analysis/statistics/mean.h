// The mean, its standard deviation and Student's interval.
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

struct MeanAndSd {
  double mean = 0;
  std::optional<double> sd;  // with n - 1; nothing for one value
};

// Nothing for no values.
std::optional<MeanAndSd> mean_and_sd(const std::vector<double>& values);

// mean -+ t(n-1; (1+level)/2) sd / sqrt(n) (Student 1908); nothing for less than two values.
// 0 < level < 1.
std::optional<Interval> mean_interval(const std::vector<double>& values, double level);

}  // namespace promenade::analysis
