// Mean and standard deviation, with the interval of the mean by Student's t (1908).
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

struct Moments {
  int n = 0;
  std::optional<double> mean, sd;   // sd with n - 1; nothing for n < 2
  std::optional<Interval> mean_ci;  // mean -+ t_(n-1) sd / sqrt(n); nothing for n < 2
};

// Of finite values. 0 < level < 1.
Moments moments_of(const std::vector<double>& values, double level = 0.95);

}  // namespace promenade::analysis
