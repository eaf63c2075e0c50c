#include "motion/graph/window_distance.h"

#include <cassert>
#include <cmath>

#include "motion/angles.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

// Visits the pairs of points of two windows with their weight.
template <typename Visit>
void for_pairs(const Clouds& a, int i, const Clouds& b, int j, std::span<const double> taper,
               const Visit& visit) {
  const Eigen::Index points = a.weights.size();
  const auto window = static_cast<Eigen::Index>(taper.size());
  for (Eigen::Index p = 0; p < window; ++p) {
    const Eigen::Index in_a = (i + p) * points, in_b = (j - window + 1 + p) * points;
    for (Eigen::Index m = 0; m < points; ++m) {
      visit(taper[static_cast<std::size_t>(p)] * a.weights(m), Vector3d(a.points.col(in_a + m)),
            Vector3d(b.points.col(in_b + m)));
    }
  }
}

}  // namespace

double WindowDistance::rms() const { return weight > 0 ? std::sqrt(sum / weight) : 0; }

WindowDistance window_distance(const Clouds& a, int i, const Clouds& b, int j,
                               std::span<const double> taper) {
  assert(a.weights.size() == b.weights.size() && "clouds of the same points");
  WindowDistance result;
  Vector3d mean_a = Vector3d::Zero(), mean_b = Vector3d::Zero();
  for_pairs(a, i, b, j, taper, [&](double w, const Vector3d& p, const Vector3d& q) {
    result.weight += w;
    mean_a += w * p;
    mean_b += w * q;
  });
  mean_a /= result.weight;
  mean_b /= result.weight;
  double sine = 0, cosine = 0;
  for_pairs(a, i, b, j, taper, [&](double w, const Vector3d& p, const Vector3d& q) {
    const Vector3d u = p - mean_a, v = q - mean_b;
    sine += w * (u.x() * v.z() - v.x() * u.z());
    cosine += w * (u.x() * v.x() + u.z() * v.z());
  });
  PlanarMove& move = result.move;
  move.theta = std::atan2(sine, cosine);
  if (move.theta <= -pi) move.theta = pi;  // half a turn has one name
  const Vector3d turned = moved(PlanarMove{move.theta, 0, 0}, mean_b);
  move.x0 = mean_a.x() - turned.x();
  move.z0 = mean_a.z() - turned.z();
  const double c = std::cos(move.theta), s = std::sin(move.theta);
  for_pairs(a, i, b, j, taper, [&](double w, const Vector3d& p, const Vector3d& q) {
    const Vector3d u = p - mean_a, v = q - mean_b;
    result.sum += w * (std::pow(u.x() - c * v.x() - s * v.z(), 2) +
                       std::pow(u.z() + s * v.x() - c * v.z(), 2) + std::pow(p.y() - q.y(), 2));
  });
  return result;
}

}  // namespace promenade::motion
