// How unlike two windows of frames are when the second is turned about the vertical and moved
// over the ground onto the first, as well as can be ([K] Eq. 1 to 4): the closed form, in
// double. Maps of all pairs are made in single precision (distance_map.h) and then asked here.
#pragma once

#include <span>

#include "motion/graph/clouds.h"
#include "motion/graph/planar_move.h"

namespace promenade::motion {

struct WindowDistance {
  double sum = 0;      // of w |p - T p'|^2: square of the unit of the points
  double weight = 0;   // W, sum of all w
  PlanarMove move;     // T: lays B's window over A's
  double rms() const;  // sqrt(sum / W): in the unit of the points
};

// A_i .. A_{i+k-1} against B_{j-k+1} .. B_j. `taper` (k) weighs the frames of a window; point
// m at frame p of the window has weight taper[p] weights[m]. Both clouds have the same
// weights; the windows lie within the takes.
WindowDistance window_distance(const Clouds& a, int i, const Clouds& b, int j,
                               std::span<const double> taper);

}  // namespace promenade::motion
