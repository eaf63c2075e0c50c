#include "analysis/statistics/f_quantile.h"

#include <boost/math/special_functions/beta.hpp>

#include "analysis/statistics/quiet.h"

namespace promenade::analysis {

// below / (below + above F) is beta distributed; small where F is large.
double f_upper_quantile(double p, double above, double below) {
  double rest = 0;
  const double part = boost::math::ibeta_inv(below / 2, above / 2, p, &rest, Quiet());
  return below * rest / (above * part);
}

}  // namespace promenade::analysis
