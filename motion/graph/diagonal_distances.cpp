#include "motion/graph/diagonal_distances.h"

#include <algorithm>
#include <cmath>

namespace promenade::motion {

DiagonalDistances::DiagonalDistances(const MapSide& a, const MapSide& b, const MapArea& area)
    : a_(a), b_(b), even_(is_even(a.taper)), first_(area.column - (area.row + area.rows - 1)) {
  diagonals_.resize(static_cast<std::size_t>(area.rows + area.columns - 1));
}

double DiagonalDistances::mean_square(int row, int column) {
  Diagonal& diagonal = diagonals_[static_cast<std::size_t>(column - row - first_)];
  const int window = a_.window();
  // Three steps or so are cheaper than a window.
  if (!even_ || diagonal.row < 0 || std::abs(row - diagonal.row) > window / 4) {
    diagonal = {row, anew(row, column)};
  }
  const double share = a_.taper.front();
  for (int& r = diagonal.row; r < row; ++r) {
    const int c = column + r - row;
    add_frames(r + window, c + window, share, diagonal.sums);
    add_frames(r, c, -share, diagonal.sums);
  }
  for (int& r = diagonal.row; r > row; --r) {
    const int c = column + r - row;
    add_frames(r - 1, c - 1, share, diagonal.sums);
    add_frames(r + window - 1, c + window - 1, -share, diagonal.sums);
  }
  const WindowMoments &a = a_.moments, &b = b_.moments;
  const Sums& sums = diagonal.sums;
  const double c = sums.c - (a.x(row) * b.x(column) + a.z(row) * b.z(column));
  const double s = sums.s - (a.x(row) * b.z(column) - a.z(row) * b.x(column));
  const double square = a.ground(row) + a.yy(row) + b.ground(column) + b.yy(column) -
                        2 * (std::sqrt(c * c + s * s) + sums.y);
  return std::max(0.0, square);
}

DiagonalDistances::Sums DiagonalDistances::anew(int row, int column) const {
  Sums sums;
  for (int p = 0; p < a_.window(); ++p) {
    add_frames(row + p, column + p, a_.taper[static_cast<std::size_t>(p)], sums);
  }
  return sums;
}

// `share` of frame f of A against frame g of B.
void DiagonalDistances::add_frames(int f, int g, double share, Sums& sums) const {
  const Eigen::Index points = a_.weights.size(), from = f * points, to = g * points;
  const auto w = a_.weights.array();
  const auto ax = a_.x.segment(from, points), az = a_.z.segment(from, points);
  const auto bx = b_.x.segment(to, points), bz = b_.z.segment(to, points);
  sums.c += share * (w * (ax * bx + az * bz)).sum();
  sums.s += share * (w * (ax * bz - az * bx)).sum();
  sums.y += share * (w * a_.y.segment(from, points) * b_.y.segment(to, points)).sum();
}

}  // namespace promenade::motion
