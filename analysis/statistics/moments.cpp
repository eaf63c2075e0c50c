#include "analysis/statistics/moments.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "analysis/statistics/quiet.h"

namespace promenade::analysis {

Moments moments_of(const std::vector<double>& values, double level) {
  Moments moments;
  moments.n = static_cast<int>(values.size());
  if (values.empty()) return moments;
  const auto n = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value;
  const double mean = sum / n;
  moments.mean = mean;
  if (values.size() < 2) return moments;
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  moments.sd = std::sqrt(squares / (n - 1));
  const boost::math::students_t_distribution<double, Quiet> t(n - 1);
  const double half = quantile(complement(t, (1 - level) / 2)) * *moments.sd / std::sqrt(n);
  moments.mean_ci = if_finite(Interval{mean - half, mean + half});
  return moments;
}

}  // namespace promenade::analysis
