// Rotations and rotation vectors (axis times angle, radians).
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace promenade::motion {

// The short way: the length is at most pi.
inline Eigen::Vector3d log_of(Eigen::Quaterniond q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  const double scale = sine > 1e-12 ? 2 * std::atan2(sine, q.w()) / sine : 2;
  return scale * q.vec();
}

inline Eigen::Quaterniond exp_of(const Eigen::Vector3d& turn) {
  const double half = 0.5 * turn.norm();
  const double scale = half > 1e-12 ? 0.5 * std::sin(half) / half : 0.5;
  return {std::cos(half), scale * turn.x(), scale * turn.y(), scale * turn.z()};
}

}  // namespace promenade::motion
