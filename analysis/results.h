// Everything that a report says, computed; its pages, tables and figures only
// show it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/comparisons.h"
#include "analysis/failure_tests.h"
#include "analysis/omnibus.h"
#include "analysis/preference.h"
#include "analysis/summaries.h"
#include "analysis/times.h"

namespace promenade::analysis {

struct Results {
  Log log;
  SelectionOptions options;
  Selection selection;
  Dataset data;
  std::vector<Comparison> comparisons;
  std::vector<FailureRatio> failures;
  std::vector<Summary> summaries;
  std::vector<TargetSummary> target_summaries;
  std::vector<OmnibusTest> omnibus;
  FailureTests failure_tests;
  std::vector<TaskTimes> times;
  Preference preference;

  // The results of one measure in one task, averaged per participant.
  std::vector<const Comparison*> pairs(int measure, int task) const;
  std::vector<const Summary*> summaries_of(int measure, int task) const;
};

// Reads the databases and runs every test. Throws InputError, also when no trial is
// left to analyse; OutsideError when `progress` stops it.
Results compute_results(const std::vector<std::string>& databases, const SelectionOptions& options,
                        const Progress& progress = {});

}  // namespace promenade::analysis
