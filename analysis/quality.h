// How well the program and the session ran where people worked: what a sensitivity analysis
// leaves out (docs/methods.md, 6).
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset.h"

namespace promenade::analysis {

// Of one interface, or of all. What did not end with an outcome of its own (skipped, aborted,
// cut off) has no trial in the data set.
struct QualityCount {
  int interface = -1;  // -1: all
  int trials = 0;
  int flagged = 0;  // for any of the four reasons that follow
  int interrupted = 0, paused = 0, slow_frames = 0, coarse_time = 0;
  int late_frames = 0;
  double minutes = 0;  // from start to end of the trials, pauses included
  std::optional<double> late_per_minute;
  // Of the largest uncertainty of any input in each trial; nothing without a trial.
  std::optional<double> median_uncertainty_ms, largest_uncertainty_ms;
  int skipped = 0, aborted = 0, cut_off = 0;
};

struct Quality {
  std::vector<QualityCount> counts;  // all, then each interface
  int resumed_sessions = 0;          // of people analysed: went on after an interruption
  int resumptions = 0;               // how often in all
};

Quality quality_of(const Log& log, const Selection& selection, const Dataset& data);

}  // namespace promenade::analysis
