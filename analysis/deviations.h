// Where sessions of those analysed went another way than the plan: trials that are missing, were
// skipped or done again, interruptions, and orders used more or less often than once.
#pragma once

#include <string>
#include <vector>

#include "analysis/log.h"
#include "analysis/selection.h"

namespace promenade::analysis {

enum class DeviationKind {
  missing_trials,   // fewer trials than others of the same version of the study; count: how many
  skipped,          // by the experimenter; what: the trial, reason
  not_ended,        // aborted or cut off; what: the trial
  repeated_trials,  // done again, and only the last counts; count: how many
  repeat,           // the experimenter's act; what: trial or block, reason
  resumed,          // after an interruption; count: how often
  order_repeated,   // another person has the same order; what: the order
  order_unused,     // nobody analysed has it (person -1); what: the order
};

struct Deviation {
  DeviationKind kind = DeviationKind::skipped;
  std::string person;  // code; empty: nobody
  int count = 1;
  std::string what, reason;
};

// By person, and orders that nobody has at the end. The plan itself is not in the log: a session
// should have as many trials as most of its version, and each order from 0 to the largest of those
// analysed should be there once. Simulated, pilot and real sessions have orders of their own.
std::vector<Deviation> deviations_of(const Log& log, const Selection& selection);

}  // namespace promenade::analysis
