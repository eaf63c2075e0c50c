#include "analysis/published/published_pairs.h"

#include <algorithm>
#include <cmath>

#include "analysis/item.h"
#include "motion/models/rand_index.h"
#include "motion/problem.h"
#include "study/ratings.h"

namespace promenade::analysis {
namespace {

using motion::AdjectivePair;
using motion::PairFate;

// Of several stations each has its own raters.
study::RatingsTable ratings_in(const Log& log, const SelectionOptions& options) {
  const study::RatingSelection selection{options.include_simulated, options.include_pilot, ""};
  std::vector<study::NamedRating> all;
  bool simulated = false;
  std::vector<std::string> motions;
  for (const LoggedFile& file : log.files) {
    const auto found = study::read_database_ratings(file.file, selection);
    for (const motion::Rating& one : found.table.ratings) {
      all.push_back({file.file + ":" + std::to_string(one.rater),
                     item(found.table.motions, one.motion), item(found.table.pairs, one.pair),
                     one.value});
    }
    simulated = simulated || found.table.simulated;
    if (motions.empty()) motions = found.table.motions;
  }
  study::RatingsTable table = study::make_ratings_table(all, motions);
  table.simulated = simulated;
  return table;
}

std::string name_of(const AdjectivePair& pair) {
  return std::string(pair.left) + "-" + std::string(pair.right);
}

std::optional<double> defined(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void add_run(const study::AdjectiveModel& model, PublishedPair& pair) {
  const auto& names = model.table.pairs;
  const auto found = std::find(names.begin(), names.end(), pair.name);
  if (found == names.end()) return;
  const auto row = static_cast<int>(found - names.begin());
  const motion::Quantification& q = model.quantification;
  pair.fate = item(q.fate, row);
  pair.extreme = defined(q.extreme(row));
  pair.sigma = defined(q.disagreement(row));
  const auto kept = std::find(q.kept.begin(), q.kept.end(), row);
  if (kept == q.kept.end()) return;
  const int cluster = item(q.cluster, static_cast<int>(kept - q.kept.begin()));
  pair.cluster = item(model.names, cluster);
}

// Of names, by first appearance.
int label_of(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) names.push_back(name);
  return static_cast<int>(std::find(names.begin(), names.end(), name) - names.begin());
}

double alike(const std::vector<PublishedPair>& pairs) {
  std::vector<std::string> printed_names, names;
  std::vector<int> printed, found;
  for (const PublishedPair& pair : pairs) {
    if (pair.cluster.empty() || pair.cluster_in_print.empty()) continue;
    printed.push_back(label_of(pair.cluster_in_print, printed_names));
    found.push_back(label_of(pair.cluster, names));
  }
  return motion::adjusted_rand_index(printed, found);
}

void count(PublishedPairs& result) {
  for (const PublishedPair& pair : result.pairs) {
    const bool kept = pair.fate == PairFate::kept;
    result.kept += kept ? 1 : 0;
    result.kept_in_both += kept && pair.kept_in_print ? 1 : 0;
    result.dropped_in_both += !kept && !pair.kept_in_print ? 1 : 0;
  }
}

}  // namespace

PublishedPairs published_pairs(const Log& log, const SelectionOptions& options,
                               AdjectivePair::Cluster AdjectivePair::*printed) {
  PublishedPairs result;
  for (const AdjectivePair& pair : motion::adjective_pairs) {
    PublishedPair row;
    row.name = name_of(pair);
    row.kept_in_print = pair.*printed != AdjectivePair::Cluster::none;
    row.cluster_in_print = std::string(motion::cluster_name(pair.*printed));
    result.pairs.push_back(std::move(row));
  }
  try {
    const auto model = study::make_adjective_model(ratings_in(log, options), log.study);
    for (PublishedPair& pair : result.pairs) add_run(model, pair);
    result.raters = model.table.raters;
    result.clusters = static_cast<int>(model.quantification.primary.rows());
    result.adjusted_rand = alike(result.pairs);
  } catch (const InputError& error) {
    result.problem = error.problems().front().message;
  }
  count(result);
  return result;
}

}  // namespace promenade::analysis
