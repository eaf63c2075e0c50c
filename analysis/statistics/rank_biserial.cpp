#include "analysis/statistics/rank_biserial.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/owens_t.hpp>
#include <cmath>

namespace promenade::analysis {
namespace {

double normal_cdf(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

struct Moments {
  double mean = 0, sd = 0;
};

// Of r for n differences from N(delta, 1).
Moments moments_of_r(double n, double delta) {
  const double p = normal_cdf(delta);
  const double h = std::sqrt(2.0) * delta;
  const double p1 = normal_cdf(h);
  const double p2 = p1 - 2 * boost::math::owens_t(h, 1 / std::sqrt(3.0));
  const double pairs = n * (n - 1) / 2;
  const double total = n * (n + 1) / 2;
  const double variance = n * p * (1 - p) + pairs * (2 * (p1 - p) * (p1 - p) + 3 * p1 * (1 - p1)) +
                          2 * pairs * (n - 2) * (p2 - p1 * p1);
  return {2 * (n * p + pairs * p1) / total - 1, 2 * std::sqrt(std::max(variance, 0.0)) / total};
}

// The E(r) from which r is just not too far above, by bisection; -1 where all are.
double lower_end(double n, double r, double z) {
  constexpr double far = 6;  // E(r) = 1 - 1e-8
  double below = -far, above = far;
  for (int i = 0; i < 50; ++i) {
    const double delta = (below + above) / 2;
    const Moments moments = moments_of_r(n, delta);
    (r - moments.mean > z * moments.sd ? below : above) = delta;
  }
  return above <= 1e-6 - far ? -1 : moments_of_r(n, above).mean;
}

}  // namespace

std::optional<Interval> rank_biserial_interval(const SignedRankTest& test, double level) {
  const int n = test.n - test.n_zero;
  if (n < 2) return std::nullopt;
  const double z = boost::math::quantile(boost::math::normal(), (1 + level) / 2);
  return Interval{lower_end(n, *test.rank_biserial, z), -lower_end(n, -*test.rank_biserial, z)};
}

}  // namespace promenade::analysis
