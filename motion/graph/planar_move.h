// A turn about the vertical and a shift over the ground: the moves that leave a motion as it
// is. Every part of a motion graph is laid beside the others by one of them ([K] 3.1).
#pragma once

#include "motion/skeleton.h"

namespace promenade::motion {

// p goes to (x cos + z sin + x0, y, -x sin + z cos + z0).
struct PlanarMove {
  double theta = 0;       // radians about +Y
  double x0 = 0, z0 = 0;  // in the unit of the points, usually metres

  Eigen::Quaterniond rotation() const;
};

Eigen::Vector3d moved(const PlanarMove& move, const Eigen::Vector3d& point);
Pose moved(const PlanarMove& move, Pose pose);

// `first`, then `next`. The angle is brought into (-pi, pi].
PlanarMove after(const PlanarMove& next, const PlanarMove& first);
PlanarMove inverse(const PlanarMove& move);

}  // namespace promenade::motion
