#include "analysis/statistics/kernel_density.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/moments.h"
#include "motion/quantile.h"

namespace promenade::analysis {
namespace {

constexpr double root_two_pi = 2.5066282746310002;

double bandwidth_of(const std::vector<double>& sorted, double sd) {
  const double iqr =
      motion::quantile_of_sorted(sorted, 0.75) - motion::quantile_of_sorted(sorted, 0.25);
  const double spread = iqr > 0 ? std::min(sd, iqr / 1.34) : sd;
  return 0.9 * spread * std::pow(static_cast<double>(sorted.size()), -0.2);
}

double density_at(const std::vector<double>& values, double x, double bandwidth) {
  double sum = 0;
  for (const double value : values) {
    const double z = (x - value) / bandwidth;
    sum += std::exp(-z * z / 2);
  }
  return sum / (static_cast<double>(values.size()) * bandwidth * root_two_pi);
}

}  // namespace

std::optional<KernelDensity> kernel_density(const std::vector<double>& values, int points) {
  if (values.size() < 2) return std::nullopt;
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const double sd = moments_of(sorted).sd.value_or(0);
  const double extent = sorted.back() - sorted.front();
  if (!(extent > 0) || !(sd > 0)) return std::nullopt;
  KernelDensity result;
  result.bandwidth = bandwidth_of(sorted, sd);
  for (int i = 0; i < points; ++i) {
    const double x = sorted.front() + extent * i / (points - 1);
    result.at.push_back(x);
    result.density.push_back(density_at(sorted, x, result.bandwidth));
  }
  return result;
}

}  // namespace promenade::analysis
