// Boost.Math that answers what it cannot compute with NaN or infinity instead of throwing, and
// a word for "not defined" that never is a NaN.
#pragma once

#include <boost/math/policies/policy.hpp>
#include <cmath>
#include <optional>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

namespace errors = boost::math::policies;

// The last argument of a distribution: boost::math::students_t_distribution<double, Quiet>.
using Quiet = errors::policy<
    errors::domain_error<errors::ignore_error>, errors::pole_error<errors::ignore_error>,
    errors::overflow_error<errors::ignore_error>, errors::rounding_error<errors::ignore_error>,
    errors::evaluation_error<errors::ignore_error>>;

inline std::optional<double> if_finite(double value) {
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

inline std::optional<Interval> if_finite(const Interval& interval) {
  if (!std::isfinite(interval.lower) || !std::isfinite(interval.upper)) return std::nullopt;
  return interval;
}

// Nothing where it is divided by zero, or what goes in is not finite.
inline std::optional<double> ratio(double above, double below) {
  if (below == 0) return std::nullopt;
  return if_finite(above / below);
}

}  // namespace promenade::analysis
