// How a long computation says how far it is, and hears that it is to stop.
#pragma once

#include <functional>
#include <string>

#include "motion/problem.h"

namespace promenade::analysis {

// Called with what is being done ("figures drawn"), how many of how many; false: stop.
// May be empty.
using Progress = std::function<bool(const std::string& what, int done, int count)>;

// Throws OutsideError when `progress` wants to stop.
inline void report_progress(const Progress& progress, const std::string& what, int done,
                            int count) {
  if (progress && !progress(what, done, count)) {
    throw OutsideError("stopped before it was done; nothing was written");
  }
}

}  // namespace promenade::analysis
