// Rotations as the three angles that plain BVH writes.
#pragma once

#include <Eigen/Geometry>

namespace promenade::motion {

// Degrees about Z, Y, X with R = Rz Ry Rx; right near 90 degrees about Y, too.
Eigen::Vector3d zyx_angles(const Eigen::Matrix3d& rotation);

// Of all ways to write the rotation the one nearest to these angles, so that angles run
// on from frame to frame and other programs can interpolate.
Eigen::Vector3d zyx_angles(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& previous);

}  // namespace promenade::motion
