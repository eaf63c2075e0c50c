// From one lasting change to another, smoothly.
#pragma once

#include <algorithm>

namespace promenade::motion {

// Goes over from `from` to `to`, and the velocity that the change has at either end dies away
// (within `reach_s`, or half of the time if that is less). `Value` is a vector.
template <class Value>
struct Fade {
  double seconds;
  Value from, to, leaving, arriving;  // the last two per second
  double reach_s = 0.1;

  Value at(double t) const {
    const double x = t / seconds;
    const double eased = x * x * (3 - 2 * x);
    const double reach = std::min(reach_s, 0.5 * seconds);
    const auto ramp = [reach](double u) {
      const double rest = std::max(1 - u / reach, 0.0);
      return u * rest * rest;
    };
    return (1 - eased) * from + eased * to + ramp(t) * leaving - ramp(seconds - t) * arriving;
  }
};

}  // namespace promenade::motion
