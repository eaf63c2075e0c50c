// A distance map made small enough to look at: of one pair of takes, or of many laid end to end.
// Only numbers; analysis/pictures draws them.
#pragma once

#include "motion/graph/distance_map.h"

namespace promenade::motion {

struct MapPicture {
  // Cell (y, x): the smallest RMS of its window pairs, in the unit of the points. Row y has the
  // windows from y * windows_down / rows on, rounded up, and columns likewise. Infinity: no window
  // of the cell can be used. Empty: there is no window.
  Eigen::MatrixXf rms;
  std::vector<int> starts_down, starts_across;  // the first window of each take, then how many
};

// The windows of `down` against those of `across`, in at most `most_rows` x `most_columns` cells,
// on all cores. The same vector twice: a symmetric picture in half the time.
MapPicture map_picture(const std::vector<const Clouds*>& down,
                       const std::vector<const Clouds*>& across, std::span<const double> taper,
                       int most_rows, int most_columns);

}  // namespace promenade::motion
