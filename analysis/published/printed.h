// What the sources print about the studies that [study] published names (study/published.h): every
// number that we know, with its place. Nothing here is computed; published.h holds a run against
// it. [N] and [O] are in the README.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "motion/models/adjective_pairs.h"

namespace promenade::analysis {

enum class Quantity {
  participants,
  walks,
  interfaces,
  practice_targets,
  targets,
  limit_s,
  threshold_m,
  rated_pairs,  // of adjectives
  kept_pairs,
  clusters
};

struct PrintedCount {
  Quantity quantity = Quantity::participants;
  double value = 0;
  std::string_view place;
};

// A Wilcoxon signed-rank test of two interfaces.
struct PrintedTest {
  std::string_view measure;  // d_final of the guess, or time_s of the match
  std::string_view a, b;     // types of interfaces
  int target = 0;            // from 1; 0: all of them, pooled
  double p = 1;
  // No rank sum of as many untied differences as people has this p: there were ties or zeros, or
  // somebody is missing.
  bool needs_ties = false;
};

// What is said without a number.
enum class Claim { equal, a_less, a_more };
enum class ClaimedTask { any, find, match };

struct PrintedClaim {
  std::string_view words, place;
  Claim claim = Claim::equal;
  std::string_view a, b;        // types of interfaces
  std::string_view measure;     // of the trials, or an item or score of the instrument
  std::string_view instrument;  // empty: of the trials
  ClaimedTask task = ClaimedTask::any;
};

struct PrintedPreference {
  std::string_view type;  // of the interface that most people would rather use
  int chosen = 0, answers = 0;
  double p = 1;                 // exact binomial, two-sided
  double lower = 0, upper = 1;  // Clopper-Pearson, 95 %
  std::string_view place;
};

struct PrintedStudy {
  std::string_view name;   // as [study] published
  std::string_view title;  // "Oshita et al., user study (section 6)"
  std::vector<PrintedCount> counts;
  std::vector<PrintedTest> tests;
  std::vector<PrintedClaim> claims;
  std::optional<PrintedPreference> preference;
  // Of questionnaires: the printed cluster of each pair of adjectives.
  motion::AdjectivePair::Cluster motion::AdjectivePair::*clusters = nullptr;
  std::vector<std::string_view> notes;  // misprints and what is not printed; sentences
};

// Null: none of this name.
const PrintedStudy* printed_study(std::string_view name);

// The parts of it, one for each source.
std::vector<PrintedStudy> printed_by_oshita();
std::vector<PrintedStudy> printed_by_normoyle();

}  // namespace promenade::analysis
