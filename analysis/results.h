// Everything that a report says, computed; its pages, tables and figures only
// show it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/comparisons.h"
#include "analysis/deviations.h"
#include "analysis/failure_tests.h"
#include "analysis/flow.h"
#include "analysis/map_time.h"
#include "analysis/omnibus.h"
#include "analysis/order_effects.h"
#include "analysis/preference.h"
#include "analysis/prereg/prereg_check.h"
#include "analysis/published/published.h"
#include "analysis/quality.h"
#include "analysis/questionnaire_results.h"
#include "analysis/rating_quality.h"
#include "analysis/ratings/rated_pairs.h"
#include "analysis/regret.h"
#include "analysis/sensitivity.h"
#include "analysis/summaries.h"
#include "analysis/times.h"

namespace promenade::analysis {

// What the sliders of adjectives were made of, in the newest version of the study.
struct AdjectiveSource {
  std::string source;  // "ratings.csv", "14 simulated raters, seed 1"
  int raters = 0;
  bool simulated = false;  // no person judged the motions
};

struct Results {
  Log log;
  SelectionOptions options;
  Selection selection;
  Dataset data;
  Reachability reachability;
  MapTimes map_times;
  std::vector<Comparison> comparisons;
  std::vector<FailureRatio> failures;
  std::vector<Summary> summaries;
  Flow flow;
  Quality quality;
  RatingQuality ratings;                  // of motions
  std::optional<RatedPairs> rated_pairs;  // where rate tasks ask pairs of adjectives
  std::vector<Deviation> deviations;
  OrderEffects order;
  std::vector<QuestionnaireResult> questionnaires;
  Sensitivity sensitivity;
  std::optional<PreregCheck> prereg;  // with `report --prereg` only
  std::vector<TargetSummary> target_summaries;
  std::vector<OmnibusTest> omnibus;
  FailureTests failure_tests;
  std::vector<TaskTimes> times;
  Preference preference;
  std::optional<AdjectiveSource> adjectives;  // where an interface or targets used them
  Published published;  // beside the printed study that [study] published names
  int rated_walks = 0;  // pages about single walks of rate tasks, which have no interface

  // The results of one measure in one task, averaged per participant.
  std::vector<const Comparison*> pairs(int measure, int task) const;
  std::vector<const Summary*> summaries_of(int measure, int task) const;
};

// Reads the databases and runs every test. Without `registry` there is no regret and no map.
// Throws InputError, also when no trial and no rated walk is left to analyse; OutsideError when
// `progress` stops it.
Results compute_results(const std::vector<std::string>& databases, const SelectionOptions& options,
                        const Progress& progress = {},
                        const study::InterfaceRegistry* registry = nullptr);

}  // namespace promenade::analysis
