// The convex hull of points of the plane.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace promenade::motion {

// Corners of the smallest convex polygon around some columns of `points` (2 x N), as
// columns, counterclockwise (y up), from the leftmost on; what lies on an edge is no
// corner. Fewer than three columns: as they are.
std::vector<int> convex_hull(const Eigen::Matrix2Xd& points, std::vector<int> columns);

}  // namespace promenade::motion
