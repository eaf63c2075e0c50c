// The distances of all pairs of windows of two takes ([K] 3.2), as root mean squares in metres:
// products of matrices and running sums along diagonals, in single precision, tile by tile, so that
// memory stays bounded. Window `r` of A is A_r .. A_{r+k-1}, and so is window `c` of B: B_c ..
// B_{c+k-1} (c = j - k + 1 in window_distance.h). Values are good for finding minima, not for
// reporting: ask window_distance() for these.
#pragma once

#include <functional>
#include <span>

#include "motion/graph/clouds.h"

namespace promenade::motion {

// Rows are windows of A from `row` on, columns windows of B from `column` on.
struct MapTile {
  int row = 0, column = 0;
  Eigen::MatrixXf rms;  // metres
};

// Calls `visit` for tiles that cover every pair once, in order of rows, then columns. With one
// and the same take twice, tiles wholly below the diagonal are left out: the map is symmetric.
void for_each_tile(const Clouds& a, const Clouds& b, std::span<const double> taper,
                   const std::function<void(const MapTile&)>& visit);

}  // namespace promenade::motion
