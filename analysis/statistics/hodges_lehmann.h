// The Hodges-Lehmann estimates of location and shift (Hodges & Lehmann 1963)
// with the confidence intervals that belong to the rank tests (Tukey 1949;
// Hollander & Wolfe 1999, sections 3.3 and 4.3).
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"
#include "analysis/statistics/walsh_averages.h"

namespace promenade::analysis {

// One of each pair of Walsh averages A_(c) and A_(M+1-c), c the largest number
// with 2 P(W <= c-1) <= 1 - level under the untied signed-rank distribution.
struct LocationInterval {
  Interval interval;
  double level = 0;  // attained: 1 - 2 P(W <= c-1), never below what was asked
};

// Without the level.
inline std::optional<Interval> interval_of(const std::optional<LocationInterval>& location) {
  return location ? std::optional(location->interval) : std::nullopt;
}

// Median of the Walsh averages; nothing for no differences.
std::optional<double> hodges_lehmann(const WalshAverages& walsh);

// Nothing where the level cannot be attained (95 %: n <= 5). Above
// sign_flips_limit differences c comes from the normal approximation. n: how
// many differences the averages were made of.
std::optional<LocationInterval> hodges_lehmann_interval(const WalshAverages& walsh, int n,
                                                        double level);

// The shift between two independent samples: the median of all x_i - y_j.
std::optional<double> shift_estimate(const std::vector<double>& x, const std::vector<double>& y);

// The interval of the shift by order statistics of the rank-sum distribution, as
// R's wilcox.test(exact = TRUE) has it: of x.size() + y.size() untied values;
// nothing with ties. Where the level cannot be attained it is the whole range.
std::optional<Interval> shift_interval(const std::vector<double>& x, const std::vector<double>& y,
                                       double level);

}  // namespace promenade::analysis
