// The plan of an analysis, as PLAN.toml says it (docs/analysts.md): what will be tested, on whom,
// and when it is enough.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/dataset.h"

namespace promenade::study {
struct Study;
}  // namespace promenade::study

namespace promenade::analysis {

struct PlannedPair {
  std::string a, b;  // names of interfaces; differences are in the order of the study
};

// A primary measure: the signed-rank test of its means per participant, in one task.
struct PlannedMeasure {
  std::string measure, task;
  std::vector<PlannedPair> pairs;  // empty: all
};

// Over which tests Holm's correction runs.
enum class HolmFamily {
  measure,  // the pairs of one measure in one task
  all       // every planned test
};

// In words for people, and by rules that the program can check (docs/methods.md, 6).
struct ExclusionRules {
  std::vector<std::string> words;
  std::optional<int> min_trials;            // fewer trials that count: out
  std::optional<double> max_flagged_share;  // a larger share of flagged trials: out, 0 to 1
};

struct AnalysisPlan {
  std::vector<std::string> hypotheses;  // in words, at least one
  std::vector<PlannedMeasure> measures;
  ExclusionRules exclusions;
  HolmFamily family = HolmFamily::measure;
  double alpha = 0.05;
  int participants = 0;  // who must be analysed in the end
  std::string stopping;  // the rule in words
};

// Throws InputError with everything that is wrong, by line and column: unknown keys, and tasks,
// measures and interfaces that the study does not have; without a `study` names are not checked.
AnalysisPlan read_plan(const std::string& file, std::string_view text, const study::Study* study);

// What a study measures in each trial: results, ratings after a trial, and process measures.
std::vector<Measure> measures_of(const study::Study& study);

}  // namespace promenade::analysis
