// Power by resampling a pilot: whole people are drawn from it with replacement, n at a time.
// Rule: the difference that the pilot happened to show is taken out, and the smallest effect that
// would matter is put in its place; a power for the effect of the pilot would only repeat its p.
#pragma once

#include "analysis/power/power.h"

namespace promenade::analysis {

struct SmallestEffect {
  std::string task, measure;  // names
  double effect = 0;          // of a - b, in the unit of the measure; not 0
  std::string a, b;           // names; both empty: every pair in turn
};

// The differences of each pair are centred around their Hodges-Lehmann estimate. Those of the
// pair in question are shifted by the effect, all others stay without one, which leaves Holm the
// least to go by. Pairs for which fewer than two people have both values are left out.
// Throws InputError about `file`, the pilot, for names it does not have and where no pair is
// left; OutsideError when `progress` stops it.
PowerTable resampled_power(const Dataset& pilot, const std::string& file,
                           const SmallestEffect& effect, const PowerQuestion& question);

}  // namespace promenade::analysis
