// The local minima of distance maps: where two windows are more alike than any two that begin a
// frame earlier or later ([K] 3.2). They are found in single precision and settled in double, so
// that they are the same on every machine.
//
// A window pair is a minimum when none of its eight neighbours in the map (those that there are)
// is smaller. Distances that round to the same hundredth of a millimetre are ties; of them the
// pair with the smaller row, then column, counts as smaller. So of somebody who stands motionless
// the first window is enough. Windows with points that are no numbers are in no minimum and in no
// neighbourhood.
#pragma once

#include "motion/graph/distance_map.h"
#include "motion/graph/planar_move.h"

namespace promenade::motion {

struct MapMinimum {
  int row = 0, column = 0;
  double rms = 0;   // in the unit of the points; of window_distance()
  PlanarMove move;  // lays B's window over A's
};

struct MinimaQuery {
  // In the map of a take with itself: column - row, in frames. At least 1.
  int least_apart = 1;
  int most_apart = 1 << 30;
  // Minima above it are counted, but not given.
  double most_rms = 1e300;
  Instructions instructions = usable_instructions().back();
};

struct MapMinima {
  std::vector<MapMinimum> found;  // in order of rows, then columns
  int count = 0;                  // with those above most_rms
};

// The areas of the map of two sides in which minima can be.
std::vector<MapArea> minima_areas(const MapSide& a, const MapSide& b, const MinimaQuery& query);

// The minima in an area of the map. `a` and `b` are the same object for a take with itself: then
// only those above the diagonal.
MapMinima minima_in(const MapSide& a, const MapSide& b, const MapArea& area,
                    const MinimaQuery& query);

}  // namespace promenade::motion
