#include "motion/zyx_angles.h"

#include <cmath>

#include "motion/angles.h"

namespace promenade::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d about(double degrees, const Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * degree, axis).toRotationMatrix();
}

double nearest_turn(double angle, double previous) {
  return angle - 360 * std::round((angle - previous) / 360);
}

}  // namespace

Vector3d zyx_angles(const Matrix3d& rotation) {
  // Each angle is taken from what the ones before leave.
  const double z = std::atan2(rotation(1, 0), rotation(0, 0)) / degree;
  const Matrix3d rest = about(-z, Vector3d::UnitZ()) * rotation;
  const double y = std::atan2(-rest(2, 0), rest(0, 0)) / degree;
  const double x = std::atan2(-rest(1, 2), rest(1, 1)) / degree;
  return {z, y, x};
}

Vector3d zyx_angles(const Matrix3d& rotation, const Vector3d& previous) {
  Vector3d one = zyx_angles(rotation);
  Vector3d other(one.x() + 180, 180 - one.y(), one.z() + 180);
  for (int i = 0; i < 3; ++i) {
    one(i) = nearest_turn(one(i), previous(i));
    other(i) = nearest_turn(other(i), previous(i));
  }
  return (other - previous).squaredNorm() < (one - previous).squaredNorm() ? other : one;
}

}  // namespace promenade::motion
