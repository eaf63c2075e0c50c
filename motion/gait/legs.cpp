#include "motion/gait/legs.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/gait/figure.h"

namespace promenade::motion::gait {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Angle at the end of `near` in a triangle of sides near, base and far.
double corner(double near, double base, double far) {
  const double cosine = (near * near + base * base - far * far) / (2 * near * base);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

LegTurns leg_turns(const Vector3d& hip, const Vector3d& ankle, const Vector3d& ahead) {
  const Vector3d line = ankle - hip;
  const double length = line.norm();
  assert(length < thigh_length + shank_length && "the leg reaches its footfall");
  Eigen::Matrix3d axes;
  axes.col(1) = -line / length;
  axes.col(0) = axes.col(1).cross(ahead).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  const Quaterniond straight(axes);
  const double at_hip = corner(thigh_length, length, shank_length);
  const double at_ankle = corner(shank_length, length, thigh_length);
  return {straight * AngleAxisd(-at_hip, Vector3d::UnitX()),
          straight * AngleAxisd(at_ankle, Vector3d::UnitX())};
}

}  // namespace promenade::motion::gait
