// The distances of all pairs of windows of two takes ([K] 3.2): products of matrices and sums along
// diagonals, in single precision, tile by tile, so that memory stays bounded. Window `r` of A is
// A_r .. A_{r+k-1}, and so is window `c` of B: B_c .. B_{c+k-1} (c = j - k + 1 in
// window_distance.h). Values are good for finding minima, not for reporting: ask
// window_distance() for these.
//
// With the points of windows of A and B centred over the ground, what is left after the best
// turn is, as a mean square (weights sum to 1; method: Kovar 2002 Eq. 2 to 4):
//   spread_a + spread_b - 2 sqrt(C^2 + S^2) - 2 Y,   spread = sum w (x^2 + y^2 + z^2)
// with C, S, Y as in map_kernels.h.
#pragma once

#include <functional>
#include <span>

#include "motion/graph/clouds.h"
#include "motion/graph/map_kernels.h"

namespace promenade::motion {

// What is known of every window of a take before it meets another.
struct WindowMoments {
  Eigen::ArrayXd x, z;    // weighted means
  Eigen::ArrayXd y, yy;   // of the heights, and of their squares
  Eigen::ArrayXd ground;  // variance of x plus that of z
};

// One side of a map. A window with a point that is no number, or farther than 1e9 from the
// origin, has distance infinity to all others.
struct MapSide {
  const Clouds* clouds = nullptr;
  Eigen::ArrayXd x, y, z;     // T P, over a ground whose origin is in the midst of the take; points
                              // of frames that cannot be used are 0
  Eigen::VectorXd weights;    // P, sum 1
  std::vector<double> taper;  // k, sum 1
  std::vector<bool> usable;   // of each window
  std::vector<bool> repeats;  // of each window: nothing has moved since the one before
  WindowMoments moments;

  int window() const { return static_cast<int>(taper.size()); }
  int windows() const { return static_cast<int>(usable.size()); }
};

// `clouds` stay where they are as long as the side is used.
MapSide map_side(const Clouds& clouds, std::span<const double> taper);

// Whether all frames of a window weigh the same.
bool is_even(std::span<const double> taper);

// Rows are windows of A from `row` on, columns windows of B from `column` on.
struct MapArea {
  int row = 0, column = 0, rows = 0, columns = 0;
};

struct MapTile {
  using Values = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  MapArea area;
  Values mean_square;  // of the unit of the points; infinity: a window that cannot be used
  float error = 0;     // how far these may be from the truth
};

// The areas that cover a map once, in order of rows, then columns. Of the map of a take with
// itself (`same`) those wholly below the diagonal are left out: it is symmetric.
std::vector<MapArea> map_areas(int rows, int columns, bool same);

// Makes tiles one after another in memory of its own.
class TileMaker {
 public:
  explicit TileMaker(Instructions instructions = usable_instructions().back());

  // Any area within the map. Both sides have the same weights and taper.
  void make(const MapSide& a, const MapSide& b, const MapArea& area, MapTile& tile);

 private:
  struct Origin {
    double ax, az, bx, bz, y;
  };

  void pack_first(const MapSide& side, const MapArea& area, const Origin& origin);
  void pack_second(const MapSide& side, const MapArea& area, const Origin& origin);
  void make_rows(MapTile& tile);
  void multiply_until(int frame);
  void sum_row(int row);
  ThreeRows<float> ring_row(int frame);

  const MapKernels& kernels_;
  int points_ = 0, window_ = 0, stride_ = 0, ring_rows_ = 0, multiplied_ = 0;
  MapArea area_;
  bool even_ = false;                   // all frames of a window weigh the same
  std::vector<float> taper_;            // as it is still to be applied: 1 where `even_`
  std::vector<float> fours_, panels_;   // frames of A and B (map_kernels.h)
  std::vector<float> ring_;             // rows of products, by frame of A
  std::vector<ThreeRows<float>> rows_;  // of the ring: those of a window
  std::vector<float> sums_;             // along diagonals: of (r, c) at rows - 1 - r + c
  Eigen::ArrayXf spread_a_, x_a_, z_a_, spread_b_, x_b_, z_b_;
};

// Makes all tiles, on all cores: `visit` is called once for each, in any order and from several
// threads at a time.
void for_each_tile(const Clouds& a, const Clouds& b, std::span<const double> taper,
                   const std::function<void(const MapTile&)>& visit);

}  // namespace promenade::motion
