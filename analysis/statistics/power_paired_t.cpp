#include "analysis/statistics/power_paired_t.h"

#include <algorithm>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cassert>
#include <cmath>

#include "analysis/statistics/quiet.h"

namespace promenade::analysis {
namespace {

// Beyond this Boost.Math becomes slow, then fails, and the normal part of t' = (Z + ncp) /
// sqrt(chi2 / df) adds less than 1e-8 to the probability.
constexpr double largest_exact = 1e4;

}  // namespace

std::optional<double> power_paired_t(int n, double delta, double sd, double alpha) {
  assert(sd > 0 && "the differences vary");
  if (n < 2) return std::nullopt;
  const double df = n - 1.0;
  const double ncp = std::abs(delta) / sd * std::sqrt(static_cast<double>(n));
  const double t =
      quantile(complement(boost::math::students_t_distribution<double, Quiet>(df), alpha / 2));
  if (!std::isfinite(t)) return 0;
  if (ncp > largest_exact) {
    const double bound = df / 2 * (ncp / t) * (ncp / t);
    return std::isfinite(bound) ? boost::math::gamma_p(df / 2, bound) : 1;
  }
  const boost::math::non_central_t_distribution<double, Quiet> shifted(df, ncp);
  return if_finite(std::clamp(cdf(complement(shifted, t)) + cdf(shifted, -t), 0.0, 1.0));
}

}  // namespace promenade::analysis
