// Which measures a study is about: what sensitivity and order effects are told of.
#pragma once

#include "analysis/dataset.h"

namespace promenade::analysis {

// Final and best D, time, and ratings.
inline bool is_primary(const Measure& measure) {
  return measure.kind == MeasureKind::rating || measure.name == "d_final" ||
         measure.name == "d_best" || measure.name == "time_s";
}

}  // namespace promenade::analysis
