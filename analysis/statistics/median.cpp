#include "analysis/statistics/median.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>

namespace promenade::analysis {

std::optional<double> median_of_sorted(const std::vector<double>& sorted) {
  if (sorted.empty()) return std::nullopt;
  const std::size_t half = sorted.size() / 2;
  if (sorted.size() % 2 == 1) return sorted[half];
  return sorted[half - 1] / 2 + sorted[half] / 2;
}

std::optional<double> median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return median_of_sorted(values);
}

std::optional<Interval> median_interval(std::vector<double> values, double level) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const boost::math::binomial_distribution<double> heads(static_cast<double>(values.size()), 0.5);
  std::size_t c = 0;
  while (2 * c < values.size() &&
         boost::math::cdf(heads, static_cast<double>(c)) <= (1 - level) / 2) {
    ++c;
  }
  if (c == 0) return std::nullopt;
  return Interval{values[c - 1], values[values.size() - c]};
}

}  // namespace promenade::analysis
