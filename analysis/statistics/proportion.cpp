#include "analysis/statistics/proportion.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cassert>
#include <cmath>

namespace promenade::analysis {

Interval wilson_interval(int x, int n, double level) {
  assert(0 <= x && x <= n && "successes are some of the trials");
  if (n == 0) return {0, 1};
  const double z = -boost::math::quantile(boost::math::normal(), (1 - level) / 2);
  const double count = n;
  const double successes = x;
  const double failures = n - x;
  const double centre = successes + z * z / 2;
  const double reach = z * std::sqrt(successes * failures / count + z * z / 4);
  const double scale = count + z * z;
  return {x == 0 ? 0.0 : (centre - reach) / scale, x == n ? 1.0 : (centre + reach) / scale};
}

Interval clopper_pearson_interval(int x, int n, double level) {
  assert(0 <= x && x <= n && "successes are some of the trials");
  if (n == 0) return {0, 1};
  const double tail = (1 - level) / 2;
  using Beta = boost::math::beta_distribution<double>;
  const double lower = x == 0 ? 0.0 : boost::math::quantile(Beta(x, n - x + 1), tail);
  const double upper =
      x == n ? 1.0 : boost::math::quantile(boost::math::complement(Beta(x + 1, n - x), tail));
  return {lower, upper};
}

}  // namespace promenade::analysis
