#include "analysis/statistics/mean.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace promenade::analysis {

std::optional<MeanAndSd> mean_and_sd(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const auto count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value;
  MeanAndSd result{sum / count, {}};
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  if (values.size() > 1) result.sd = std::sqrt(squares / (count - 1));
  return result;
}

std::optional<Interval> mean_interval(const std::vector<double>& values, double level) {
  if (values.size() < 2) return std::nullopt;
  const MeanAndSd all = *mean_and_sd(values);
  const auto count = static_cast<double>(values.size());
  const boost::math::students_t t(count - 1);
  const double reach = quantile(t, (1 + level) / 2) * *all.sd / std::sqrt(count);
  return Interval{all.mean - reach, all.mean + reach};
}

}  // namespace promenade::analysis
