#include "analysis/published/published_pairs.h"

#include <algorithm>
#include <cmath>

#include "analysis/item.h"
#include "motion/models/rand_index.h"

namespace promenade::analysis {
namespace {

using motion::AdjectivePair;
using motion::PairFate;

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

// Over the pairs that both kept.
double alike(const study::AdjectiveModel& model, AdjectivePair::Cluster AdjectivePair::*printed) {
  motion::PrintedClusters clusters;
  for (const std::string& name : model.kept_pairs) {
    const auto at = static_cast<std::size_t>(motion::find_adjective_pair(name));
    clusters.push_back(motion::cluster_name(motion::adjective_pairs[at].*printed));
  }
  return motion::compare_with_printed(model.quantification.cluster, clusters).rand_index;
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

PublishedPairs published_pairs(const std::optional<RatedPairs>& rated,
                               AdjectivePair::Cluster AdjectivePair::*printed) {
  PublishedPairs result;
  for (const AdjectivePair& pair : motion::adjective_pairs) {
    PublishedPair row;
    row.name = motion::pair_name(pair);
    row.kept_in_print = pair.*printed != AdjectivePair::Cluster::none;
    row.cluster_in_print = std::string(motion::cluster_name(pair.*printed));
    result.pairs.push_back(std::move(row));
  }
  result.problem = rated ? rated->problem : "nobody who is analysed rated pairs of adjectives";
  if (result.problem.empty()) {
    for (PublishedPair& pair : result.pairs) add_run(rated->model, pair);
    result.raters = rated->model.table.raters;
    result.clusters = static_cast<int>(rated->model.quantification.primary.rows());
    result.adjusted_rand = alike(rated->model, printed);
  }
  count(result);
  return result;
}

}  // namespace promenade::analysis
