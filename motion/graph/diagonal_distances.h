// Distances of pairs of windows in double, quickly: of prepared takes, and where one pair follows
// another along a diagonal of the map, from the one before. Good to 1e-7 of a take's size as RMS;
// window_distance() gives more digits, in several times the time.
#pragma once

#include "motion/graph/distance_map.h"

namespace promenade::motion {

class DiagonalDistances {
 public:
  // For pairs in the area. Both sides stay where they are.
  DiagonalDistances(const MapSide& a, const MapSide& b, const MapArea& area);

  // Of a pair of windows that can be used.
  double mean_square(int row, int column);

 private:
  struct Sums {  // of a window pair: see map_kernels.h
    double c = 0, s = 0, y = 0;
  };
  struct Diagonal {
    int row = -1;  // of `sums`; -1: nothing yet
    Sums sums;
  };

  Sums anew(int row, int column) const;
  void add_frames(int f, int g, double share, Sums& sums) const;

  const MapSide& a_;
  const MapSide& b_;
  bool even_;                        // all frames of a window weigh the same: sums can run
  int first_;                        // column - row of the first diagonal
  std::vector<Diagonal> diagonals_;  // the pair that was last asked for on each
};

}  // namespace promenade::motion
