#include "motion/gait/curve.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion::gait {

double smooth_step(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * x * (10 + x * (6 * x - 15));
}

double wave(double phase, double peak, double crispness) {
  const double cosine = std::cos(2 * pi * (phase - peak));
  if (crispness <= 0) return cosine;
  return std::tanh(crispness * cosine) / std::tanh(crispness);
}

double through(const std::vector<Knot>& knots, double x) {
  if (x <= knots.front().at) return knots.front().value;
  if (x >= knots.back().at) return knots.back().value;
  std::size_t b = 1;
  while (knots[b].at < x) ++b;
  const Knot& from = knots[b - 1];
  const Knot& to = knots[b];
  const double span = to.at - from.at;
  const double s = (x - from.at) / span;
  const double r = 1 - s;
  return r * r * (1 + 2 * s) * from.value + s * s * (1 + 2 * r) * to.value +
         span * s * r * (r * from.slope - s * to.slope);
}

Eigen::Quaterniond turned(double yaw, double pitch, double roll) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return AngleAxisd(yaw * degree, Vector3d::UnitY()) *
         AngleAxisd(pitch * degree, Vector3d::UnitX()) *
         AngleAxisd(roll * degree, Vector3d::UnitZ());
}

}  // namespace promenade::motion::gait
