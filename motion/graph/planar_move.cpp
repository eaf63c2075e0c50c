#include "motion/graph/planar_move.h"

#include <cmath>

#include "motion/angles.h"

namespace promenade::motion {

Eigen::Quaterniond PlanarMove::rotation() const {
  return {std::cos(0.5 * theta), 0, std::sin(0.5 * theta), 0};
}

Eigen::Vector3d moved(const PlanarMove& move, const Eigen::Vector3d& point) {
  const double c = std::cos(move.theta), s = std::sin(move.theta);
  return {c * point.x() + s * point.z() + move.x0, point.y(),
          -s * point.x() + c * point.z() + move.z0};
}

Pose moved(const PlanarMove& move, Pose pose) {
  pose.root = moved(move, pose.root);
  if (!pose.rotations.empty()) pose.rotations[0] = move.rotation() * pose.rotations[0];
  return pose;
}

PlanarMove after(const PlanarMove& next, const PlanarMove& first) {
  const Eigen::Vector3d shift = moved(next, Eigen::Vector3d(first.x0, 0, first.z0));
  double theta = std::remainder(next.theta + first.theta, 2 * pi);
  if (theta <= -pi) theta += 2 * pi;
  return {theta, shift.x(), shift.z()};
}

PlanarMove inverse(const PlanarMove& move) {
  const Eigen::Vector3d shift = moved({-move.theta, 0, 0}, Eigen::Vector3d(move.x0, 0, move.z0));
  return {-move.theta, -shift.x(), -shift.z()};
}

}  // namespace promenade::motion
