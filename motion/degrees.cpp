#include "motion/degrees.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "motion/angles.h"

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

// Adding this leaves the nearest whole number in the lowest bits: 1.5 * 2^52.
constexpr double rounder = 6755399441055744.0;

// `a` where bit 0 of `quarters` is 0, else `b`; with the sign turned where bit 1 of `sign`
// is set.
double pick(double a, double b, std::uint64_t quarters, std::uint64_t sign) {
  const std::uint64_t odd = 0 - (quarters & 1);  // all bits, or none
  const std::uint64_t bits =
      (std::bit_cast<std::uint64_t>(a) & ~odd) | (std::bit_cast<std::uint64_t>(b) & odd);
  return std::bit_cast<double>(bits ^ ((sign & 2) << 62));
}

// For |degrees| < 1e9, in steps of which compilers do several angles at once.
template <int most>
void add_sines_cosines(const double* degrees, int count, double* sines, double* cosines) {
  double x[most];
  std::uint64_t quarters[most];
  for (int i = 0; i < count; ++i) {
    const double shifted = degrees[i] * (1.0 / 90) + rounder;
    x[i] = (degrees[i] - 90 * (shifted - rounder)) * degree;  // the difference is exact
    quarters[i] = std::bit_cast<std::uint64_t>(shifted);
  }
  double sine[most], cosine[most];
  for (int i = 0; i < count; ++i) sine[i] = sine_near_0(x[i]);
  for (int i = 0; i < count; ++i) cosine[i] = cosine_near_0(x[i]);
  for (int i = 0; i < count; ++i) {
    sines[i] = pick(sine[i], cosine[i], quarters[i], quarters[i]);
    cosines[i] = pick(cosine[i], sine[i], quarters[i], quarters[i] + 1);
  }
}

bool is_far(double degrees) { return !(std::abs(degrees) < 1e9); }

}  // namespace

SineCosine sine_cosine_of_degrees(double degrees) {
  if (is_far(degrees)) degrees = std::remainder(degrees, 360.0);
  SineCosine result;
  add_sines_cosines<1>(&degrees, 1, &result.sine, &result.cosine);
  return result;
}

void sines_cosines_of_degrees(const double* degrees, int count, double* sines, double* cosines) {
  constexpr int block = 32;
  for (int i = 0; i < count; i += block) {
    const int size = std::min(block, count - i);
    double near[block];
    for (int k = 0; k < size; ++k) {
      near[k] = is_far(degrees[i + k]) ? std::remainder(degrees[i + k], 360.0) : degrees[i + k];
    }
    add_sines_cosines<block>(near, size, sines + i, cosines + i);
  }
}

}  // namespace promenade::motion
