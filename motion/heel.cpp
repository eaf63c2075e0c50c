#include "motion/heel.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

// Along the foot, and square to it in the upright plane that it lies in, downwards.
struct FootAxes {
  Vector3d along, down;
};

FootAxes axes_of(const Vector3d& ankle, const Vector3d& toe) {
  const Vector3d along = (toe - ankle).stableNormalized();
  const Vector3d across = along.cross(Vector3d::UnitY()).stableNormalized();
  return {along, along.cross(across)};
}

}  // namespace

Heel find_heel(const Vector3d& ankle, const Vector3d& toe) {
  return find_heel(ankle, toe, toe.y());
}

Heel find_heel(const Vector3d& ankle, const Vector3d& toe, double height) {
  const auto [along, down] = axes_of(ankle, toe);
  const Vector3d foot = toe - ankle;
  const Vector3d heel(-0.25 * foot.x(), height - ankle.y(), -0.25 * foot.z());
  return {-heel.dot(along), heel.dot(down)};
}

Vector3d heel_position(const Heel& heel, const Vector3d& ankle, const Vector3d& toe) {
  const auto [along, down] = axes_of(ankle, toe);
  return ankle - heel.behind * along + heel.below * down;
}

}  // namespace promenade::motion
