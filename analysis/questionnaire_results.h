// What people answered to each instrument: scores and scales per interface, how well the items of
// a score go together, choices, rankings, and how much was written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/comparisons.h"
#include "analysis/questionnaires.h"
#include "analysis/statistics/cronbach_alpha.h"
#include "analysis/statistics/moments.h"

namespace promenade::analysis {

// A score, or an item that is answered by a number (kind scale or number).
struct ScaleResult {
  std::string name;
  bool is_score = false;
  int interface = -1;   // that it is about, index into Dataset::interfaces; -1: none
  PersonValues values;  // of each person the mean over what was filled in
  Moments moments;      // of these; with the 95 % interval of the mean
  std::optional<double> median;
  std::optional<Interval> median_ci;  // see median_interval, 95 %
};

// Pairs of interfaces; of an instrument that has no score, its scales.
struct ScalePair {
  std::string name;
  Comparison comparison;  // Holm over the pairs of one score; its measure and task say nothing
};

// Of a score of two items or more that count alike. One row for each person: their means, over
// what was filled in whole.
struct ScoreAlpha {
  std::string score;
  int interface = -1;
  CronbachAlpha alpha;
};

struct ChoiceCount {
  std::string item;
  std::string choice;  // empty: own words
  int interface = -1;
  int count = 0, answers = 0;  // times chosen, of so many answers to the item
  bool is_pair = false;        // the item asks between two, to weigh a score
};

struct RankResult {
  std::string item, choice;
  int n = 0;                // answers
  double mean_rank = 0;     // 1: the best
  std::vector<int> counts;  // how often it stood at each place
};

// What was written is not said: it may tell who somebody is.
struct TextCount {
  std::string item;
  int texts = 0;
};

// An instrument in one version at one moment.
struct QuestionnaireResult {
  std::string instrument, version;
  std::string asked;     // start, trial, task, block or end; empty: not known
  std::string citation;  // empty: none
  bool is_known = true;  // false: its file is not in the database, so that nothing follows
  int people = 0, pages = 0;
  int declined = 0;  // single answers that people chose not to give
  std::vector<ScaleResult> scales;
  std::vector<ScalePair> pairs;
  std::vector<ScoreAlpha> alphas;
  std::vector<ChoiceCount> choices;
  std::vector<RankResult> ranks;
  std::vector<TextCount> texts;
};

// By name, version and moment. What is about an interface that is not in the data set is left
// out.
std::vector<QuestionnaireResult> questionnaire_results(
    const std::vector<FilledPage>& pages, const std::vector<study::Instrument>& instruments,
    const Dataset& data);

}  // namespace promenade::analysis
