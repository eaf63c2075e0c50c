// The power of a study's main test: how often the exact signed-rank test of the report, one
// value per person, Holm over the pairs of interfaces, finds a difference that is there. Studies
// are drawn from a pilot (analysis/power/resampling.h) or rehearsed with simulated people
// (analysis/power/rehearsal.h); this is what both have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/dataset.h"
#include "analysis/progress.h"
#include "analysis/statistics/interval.h"

namespace promenade::analysis {

struct PowerQuestion {
  std::vector<int> participants;  // each at least 1
  int studies = 1000;             // drawn of each size
  std::uint64_t seed = 1;
  double alpha = 0.05;
  int threads = 0;  // 0: one for each core; the result does not depend on them
  Progress progress = {};
};

// How often something was found in so many studies.
struct Rate {
  int found = 0, studies = 0;

  double share() const;           // 0 for no studies
  double standard_error() const;  // of Monte Carlo: sqrt(p (1 - p) / studies)
  Interval interval() const;      // Wilson, 95 %
};

// A pair of interfaces with so many participants.
struct PowerRow {
  std::string a, b;  // differences are a - b
  int participants = 0;
  Rate holm;                 // p <= alpha after Holm over all pairs
  Rate alone;                // p <= alpha without
  std::optional<double> hl;  // median over the studies of the Hodges-Lehmann estimates
  // What two formulas say of the test without Holm: a paired t test of normal differences with
  // the mean and SD of those drawn from; and the signed-rank test where a difference is positive
  // with the same probability whatever its size (statistics/power_sign_flips.h).
  std::optional<double> paired_t, sign_flips;
};

// One measure in one task.
struct PowerTable {
  std::string task;
  Measure measure;
  std::vector<PowerRow> rows;             // pairs in the order of the study, participants within
  std::vector<std::pair<int, Rate>> any;  // participants, and any pair found; empty: not asked
};

// What one study found of one pair.
struct PairFinding {
  std::optional<double> p, p_holm, hl;
};

// Adds the findings of study after study up to a row. `findings`: one for each study.
PowerRow power_row(const std::vector<PairFinding>& findings, double alpha);

// Fills in paired_t and sign_flips from the differences that the row's were drawn from.
void add_formulas(PowerRow& row, const std::vector<double>& differences, double alpha);

// The fewest of the participants asked about with which the power is at least `wanted`, by the
// estimate; nothing where none has it.
std::optional<int> enough(const std::vector<PowerRow>& rows, const std::string& a,
                          const std::string& b, double wanted = 0.8);

}  // namespace promenade::analysis
