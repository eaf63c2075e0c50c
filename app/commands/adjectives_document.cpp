#include "app/commands/adjectives_document.h"

#include <fmt/format.h>

#include <cmath>

#include "app/commands/adjectives_parts.h"
#include "app/commands/numbers.h"
#include "motion/models/cluster_names.h"
#include "motion/models/features.h"
#include "motion/models/rand_index.h"
#include "motion/models/ridge.h"

namespace promenade::app {
namespace {

using analysis::PairStatistics;
using Eigen::Index;

const char* fate_name(motion::PairFate fate) {
  static constexpr const char* names[] = {"kept", "never extreme", "disagreed", "unrated"};
  return names[static_cast<int>(fate)];
}

// Which of the two thresholds a pair fails; both are possible.
Json dropped_by(double extreme, double disagreement, const motion::QuantificationOptions& options) {
  Json thresholds = Json::array();
  if (extreme < options.least_extreme) thresholds.push_back("mu_star");
  if (disagreement > options.most_deviation) thresholds.push_back("sigma");
  return thresholds;
}

Json pairs_json(const study::AdjectiveModel& model, const analysis::RatingStatistics& statistics) {
  const study::RatingsTable& table = model.table;
  const motion::Quantification& q = model.quantification;
  Json pairs = Json::array();
  std::size_t kept = 0;
  for (std::size_t j = 0; j < table.pairs.size(); ++j) {
    const auto row = static_cast<Index>(j);
    Json pair = {{"pair", table.pairs[j]},
                 {"mean", row_json(q.mean, row)},
                 {"deviation", row_json(q.deviation, row)},
                 {"mu_star", number_json(q.extreme(row))},
                 {"sigma", number_json(q.disagreement(row))},
                 {"fate", fate_name(q.fate[j])},
                 {"dropped_by", dropped_by(q.extreme(row), q.disagreement(row), model.options)},
                 {"reason", motion::to_text(q.fate[j], model.options)},
                 {"cluster", nullptr},
                 {"flipped", nullptr}};
    if (q.fate[j] == motion::PairFate::kept) {
      pair["cluster"] = q.cluster[kept];
      pair["flipped"] = static_cast<bool>(q.flipped[kept]);
      ++kept;
    }
    pair.update(pair_agreement_json(statistics.pairs[j]));
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

Json clusters_json(const study::AdjectiveModel& model) {
  Json clusters = Json::array();
  for (std::size_t c = 0; c < model.names.size(); ++c) {
    clusters.push_back({{"name", model.names[c]},
                        {"given", !model.words.empty()},
                        {"agreement", model.name_agreement[c]},
                        {"pairs", pairs_of(model, static_cast<int>(c))},
                        {"values", row_json(model.quantification.primary, static_cast<Index>(c))}});
  }
  return clusters;
}

// The clusters that the source printed of its own two sets.
Json printed_json(const study::AdjectiveModel& model) {
  const auto tables = motion::printed_clusters(model.kept_pairs);
  const auto& cluster = model.quantification.cluster;
  return {{"set_a", comparison_json(cluster, tables[0], model.kept_pairs)},
          {"set_b", comparison_json(cluster, tables[1], model.kept_pairs)}};
}

Json list(const Eigen::VectorXd& values) {
  Json result = Json::array();
  for (const double value : values) result.push_back(number_json(value));
  return result;
}

// How well the features of a motion tell its values (V x N), and what they say of others.
Json prediction_json(const motion::MotionSet& rated, const Eigen::MatrixXd& values,
                     const motion::MotionSet* others) {
  const motion::Ridge ridge = motion::fit_ridge(motion::motion_features(rated), values);
  Json left_out = Json::array();
  for (Index c = 0; c < ridge.left_out.rows(); ++c) left_out.push_back(row_json(ridge.left_out, c));
  Json json = {{"penalty", ridge.penalty},
               {"left_out", left_out},
               {"left_out_error", list(ridge.error)},
               {"error_of_the_mean", list(ridge.baseline_error)}};
  if (!others) return json;
  json["rows"] = Json::array();
  for (const motion::Cycle& cycle : others->cycles) {
    const Eigen::VectorXd found = motion::predict(ridge, motion::motion_features(*others, cycle));
    json["rows"].push_back({{"name", cycle.name}, {"values", list(found)}});
  }
  return json;
}

// Of the primary parameters and of every pair that is left, from 51 features.
Json predictions_json(const RatedSet& rated, const motion::MotionSet* others) {
  const motion::Quantification& q = rated.model.quantification;
  Json json = {{"set", others ? Json(others->name) : Json()},
               {"simulated", rated.model.simulated()},
               {"parameters", rated.model.names}};
  json.update(prediction_json(*rated.set, q.primary, others));
  json["pairs"] = {{"names", rated.model.kept_pairs}};
  json["pairs"].update(prediction_json(*rated.set, q.scaled, others));
  return json;
}

}  // namespace

bool can_predict(const RatedSet& rated) {
  return rated.set && rated.set->size() >= 3 && rated.model.quantification.primary.rows() > 0;
}

Json adjectives_document(const RatedSet& rated, const motion::MotionSet* others) {
  const study::AdjectiveModel& model = rated.model;
  const motion::Quantification& q = model.quantification;
  const auto statistics = analysis::rating_statistics(model.table);
  Json primary = Json::array();
  for (Index c = 0; c < q.primary.rows(); ++c) primary.push_back(row_json(q.primary, c));
  Json document = {{"source", model.source},
                   {"simulated", model.simulated()},
                   {"agrees", model.agreement.agrees()},
                   {"agreement", agreement_json(model, statistics)},
                   {"raters", model.table.raters},
                   {"by_rater", raters_json(model.table, statistics)},
                   {"motions", model.table.motions},
                   {"ratings_of_motions", statistics.motions},
                   {"thresholds",
                    {{"least_extreme", model.options.least_extreme},
                     {"most_deviation", model.options.most_deviation}}},
                   {"flip", model.options.flip},
                   {"pairs", pairs_json(model, statistics)},
                   {"leaves", model.kept_pairs},
                   {"merges", merges_json(q.tree)},
                   {"clusters", clusters_json(model)},
                   {"printed", printed_json(model)},
                   {"primary", primary},
                   {"prediction", nullptr}};
  if (can_predict(rated)) document["prediction"] = predictions_json(rated, others);
  return document;
}

std::string adjectives_csv(const study::AdjectiveModel& model) {
  const study::RatingsTable& table = model.table;
  const motion::Quantification& q = model.quantification;
  const auto statistics = analysis::rating_statistics(table);
  std::string text = "pair,mu_star,sigma,fate,cluster,name,simulated," + pair_agreement_header();
  text += "\n";
  std::size_t kept = 0;
  for (std::size_t j = 0; j < table.pairs.size(); ++j) {
    const bool stays = q.fate[j] == motion::PairFate::kept;
    const auto row = static_cast<Index>(j);
    const auto cell = [](double v) { return std::isnan(v) ? std::string() : fmt::format("{}", v); };
    const int cluster = stays ? q.cluster[kept++] : -1;
    text += fmt::format("{},{},{},{},", csv_cell(table.pairs[j]), cell(q.extreme(row)),
                        cell(q.disagreement(row)), fate_name(q.fate[j]));
    text += stays ? fmt::format("{},{}", cluster,
                                csv_cell(model.names[static_cast<std::size_t>(cluster)]))
                  : std::string(",");
    text +=
        fmt::format(",{},{}\n", table.simulated ? 1 : 0, pair_agreement_cells(statistics.pairs[j]));
  }
  return text;
}

}  // namespace promenade::app
