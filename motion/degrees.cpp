#include "motion/degrees.h"

#include <cmath>
#include <cstdint>

namespace promenade::motion {
namespace {

// Taylor's series: on |x| <= pi/4 the first term left out is below 1e-17.
double sine_near_0(double x) {
  const double y = x * x;
  double sum = 1.0 / 355687428096000;  // 1/17!
  sum = sum * y - 1.0 / 1307674368000;
  sum = sum * y + 1.0 / 6227020800;
  sum = sum * y - 1.0 / 39916800;
  sum = sum * y + 1.0 / 362880;
  sum = sum * y - 1.0 / 5040;
  sum = sum * y + 1.0 / 120;
  sum = sum * y - 1.0 / 6;
  return x + x * y * sum;
}

double cosine_near_0(double x) {
  const double y = x * x;
  double sum = 1.0 / 20922789888000;  // 1/16!
  sum = sum * y - 1.0 / 87178291200;
  sum = sum * y + 1.0 / 479001600;
  sum = sum * y - 1.0 / 3628800;
  sum = sum * y + 1.0 / 40320;
  sum = sum * y - 1.0 / 720;
  sum = sum * y + 1.0 / 24;
  return 1 - 0.5 * y + y * y * sum;
}

}  // namespace

SineCosine sine_cosine_of_degrees(double degrees) {
  // Adding and taking away 1.5 * 2^52 rounds to a whole number; larger angles than this
  // allows are brought near first.
  constexpr double rounder = 6755399441055744.0;
  if (!(std::abs(degrees) < 1e9)) degrees = std::remainder(degrees, 360.0);
  const double quarters = (degrees * (1.0 / 90) + rounder) - rounder;
  const double x = (degrees - 90 * quarters) * (M_PI / 180);  // the difference is exact
  const double sine = sine_near_0(x), cosine = cosine_near_0(x);
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

}  // namespace promenade::motion
