// A report against its preregistration: was it sealed before the first session, which tests were
// planned, and what was done otherwise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/prereg/plan.h"

namespace promenade::analysis {

struct Results;

enum class SealState {
  sealed,  // every session ran on a study that names this very document
  late,    // some sessions ran before it was named
  other,   // the study names another document
  none,    // the study names no document
};

// One of the tests that were planned.
struct PlannedTest {
  std::string measure, task, a, b;
  int comparison = -1;           // index into Results::comparisons; -1: it could not be made
  std::optional<double> p_holm;  // over the family of the plan; nothing without a p
};

struct PlanDeviation {
  std::string about;           // seal, study, participants, exclusions or measures
  std::string planned, found;  // each half a sentence
};

struct PreregCheck {
  std::string file, sha256;  // of the document
  AnalysisPlan plan;
  SealState seal = SealState::none;
  std::vector<PlannedTest> tests;  // by the order of the plan
  std::vector<PlanDeviation> deviations;
  int exploratory = 0;  // tests of the report that were not planned
};

// `document`: what `file` holds. Throws InputError when it holds no plan.
PreregCheck check_prereg(const Results& results, const std::string& file,
                         const std::string& document);

std::string to_text(SealState state);  // "sealed", "late", "other", "none"

}  // namespace promenade::analysis
