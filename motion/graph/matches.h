// Where two windows of captured frames are alike: the local minima of the distance map below a
// threshold ([K] 3.2), each settled in double (map_minima.h). One match offers two transitions:
// from the start of A's window to the end of B's, and from the start of B's to the end of A's.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "motion/graph/clouds.h"
#include "motion/graph/planar_move.h"

namespace promenade::motion {

struct Match {
  int take_a = 0, take_b = 0;    // take_a <= take_b
  int start_a = 0, start_b = 0;  // first frames of the windows; in one take start_a < start_b
  double rms_m = 0;
  PlanarMove move;  // lays B's window over A's
};

// Transitions between these labels (in both directions) have a threshold of their own.
struct LabelThreshold {
  std::string from, to;
  double rms_m = 0;
};

struct MatchOptions {
  double threshold_m = 0.05;            // RMS
  std::optional<double> quantile = {};  // instead: this share of all local minima, the best, 0 to 1
  std::vector<LabelThreshold> labels = {};
  double window_s = 1.0 / 3;
  bool tapered = false;   // frames in the middle of the window count more (Hann)
  double apart_s = 0.25;  // windows of one take that begin closer together are the same moment
};

// The weights of the frames of a window, sum 1; at least two frames.
std::vector<double> window_taper(const MatchOptions& options, double frame_time);

struct LabelledClouds {
  Clouds clouds;
  std::string label;
};

struct Matches {
  std::vector<Match> found;  // in order of takes and frames
  int window = 0;            // frames
  int minima = 0;            // local minima of all maps, below the threshold or not
  double threshold_m = 0;    // that was used, also where a quantile asked for it
};

// All pairs of takes, each with itself too, on all cores: the result depends on nothing but the
// takes. Takes share their points and weights. A take shorter than a window has no match, nor has
// a window with a point that is no number. A quantile remembers every minimum; else memory grows
// with the takes and their matches, not with the maps.
// `progress` (share done, 0 to 1) returns false to stop: then an empty list comes back.
Matches find_matches(const std::vector<LabelledClouds>& takes, double frame_time,
                     const MatchOptions& options, const std::function<bool(double)>& progress = {});

}  // namespace promenade::motion
