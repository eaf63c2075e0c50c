// D while people worked: at each moment the median and quartiles over all trials with one
// interface, from table `sample` of the databases.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/results.h"

namespace promenade::analysis {

// D of one trial after each change, by time.
struct Trace {
  std::vector<double> times_s;  // since the trial began
  std::vector<double> d;        // metres
};

// D at a time: that of the last change, also when the trial has ended before; nothing before the
// first one.
std::optional<double> d_at(const Trace& trace, double time_s);

struct Curve {
  int task = 0, interface = 0;
  int trials = 0;
  std::vector<double> times_s;  // from 0 to the end of the longest trial of the task
  std::vector<double> lower_quartile, median, upper_quartile;  // metres
};

struct Curves {
  std::vector<Curve> curves;  // by task, then interface; without those that have no D
  int paused = 0;             // trials left out because they stood still or were interrupted
};

// Curve of traces at `points` times from 0 to `end_s`; traces that begin later are left out.
Curve curve_of(const std::vector<Trace>& traces, double end_s, int points);

// Opens the databases of the log again, read-only. Throws InputError when they are gone.
Curves curves_of(const Results& results);

}  // namespace promenade::analysis
