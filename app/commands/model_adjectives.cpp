#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/commands/model_parts.h"
#include "app/commands/numbers.h"
#include "app/commands/rating_source.h"
#include "app/print.h"
#include "motion/models/features.h"
#include "motion/models/ridge.h"
#include "study/study.h"

namespace promenade::app {
namespace {

using Eigen::Index;

struct Arguments {
  RatingSource source;
  std::string predict;
  motion::QuantificationOptions options;
  bool json = false, csv = false;
};

Json number(double value) { return std::isnan(value) ? Json() : Json(value); }

Json row_json(const Eigen::MatrixXd& values, Index row) {
  Json list = Json::array();
  for (const double value : values.row(row)) list.push_back(number(value));
  return list;
}

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

Json pairs_json(const study::AdjectiveModel& model) {
  const study::RatingsTable& table = model.table;
  const motion::Quantification& q = model.quantification;
  Json pairs = Json::array();
  std::size_t kept = 0;
  for (std::size_t j = 0; j < table.pairs.size(); ++j) {
    const auto row = static_cast<Index>(j);
    Json pair = {{"pair", table.pairs[j]},
                 {"mean", row_json(q.mean, row)},
                 {"deviation", row_json(q.deviation, row)},
                 {"mu_star", number(q.extreme(row))},
                 {"sigma", number(q.disagreement(row))},
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
    pairs.push_back(std::move(pair));
  }
  return pairs;
}

Json merges_json(const motion::Dendrogram& tree) {
  Json merges = Json::array();
  for (const motion::Merge& merge : tree.merges) {
    merges.push_back(
        {{"a", merge.a}, {"b", merge.b}, {"height", merge.height}, {"cost", merge.cost()}});
  }
  return merges;
}

Json clusters_json(const study::AdjectiveModel& model) {
  Json clusters = Json::array();
  for (std::size_t c = 0; c < model.names.size(); ++c) {
    Json pairs = Json::array();
    for (std::size_t i = 0; i < model.kept_pairs.size(); ++i) {
      if (model.quantification.cluster[i] == static_cast<int>(c)) {
        pairs.push_back(model.kept_pairs[i]);
      }
    }
    clusters.push_back({{"name", model.names[c]},
                        {"agreement", model.name_agreement[c]},
                        {"pairs", pairs},
                        {"values", row_json(model.quantification.primary, static_cast<Index>(c))}});
  }
  return clusters;
}

Json list(const Eigen::VectorXd& values) {
  Json result = Json::array();
  for (const double value : values) result.push_back(number(value));
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
Json predictions_json(const RatedSet& rated, const std::string& name) {
  const motion::Quantification& q = rated.model.quantification;
  std::optional<motion::MotionSet> others;
  if (!name.empty()) others = study::load_motion_set(name, "");
  const motion::MotionSet* const set = others ? &*others : nullptr;
  Json json = {{"set", others ? Json(others->name) : Json()},
               {"simulated", rated.model.simulated()},
               {"parameters", rated.model.names}};
  json.update(prediction_json(*rated.set, q.primary, set));
  json["pairs"] = {{"names", rated.model.kept_pairs}};
  json["pairs"].update(prediction_json(*rated.set, q.scaled, set));
  return json;
}

std::string pairs_csv(const study::AdjectiveModel& model) {
  const study::RatingsTable& table = model.table;
  const motion::Quantification& q = model.quantification;
  std::string text = "pair,mu_star,sigma,fate,cluster,name,simulated\n";
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
    text += fmt::format(",{}\n", table.simulated ? 1 : 0);
  }
  return text;
}

void show(const Arguments& given) {
  const RatedSet rated = load_rated_set(given.source, given.options);
  const study::AdjectiveModel& model = rated.model;
  const motion::Quantification& q = model.quantification;
  if (given.csv) return print_text(pairs_csv(model));
  if (!given.predict.empty() && !rated.set)
    throw InputError("--predict", "needs the motions that were rated: name them with --set");
  const bool enough = rated.set && rated.set->size() >= 3 && q.primary.rows() > 0;
  if (!given.predict.empty() && !enough)
    throw InputError("--predict", "needs three rated motions and a pair that is not dropped");
  Json primary = Json::array();
  for (Index c = 0; c < q.primary.rows(); ++c) primary.push_back(row_json(q.primary, c));
  Json document = {{"source", model.source},
                   {"simulated", model.simulated()},
                   {"raters", model.table.raters},
                   {"motions", model.table.motions},
                   {"thresholds",
                    {{"least_extreme", model.options.least_extreme},
                     {"most_deviation", model.options.most_deviation}}},
                   {"pairs", pairs_json(model)},
                   {"leaves", model.kept_pairs},
                   {"merges", merges_json(q.tree)},
                   {"clusters", clusters_json(model)},
                   {"primary", primary},
                   {"prediction", nullptr}};
  if (enough) document["prediction"] = predictions_json(rated, given.predict);
  print_json(document);
}

}  // namespace

void add_model_adjectives(CLI::App& model) {
  auto* command =
      model.add_subcommand("adjectives", "From ratings of motions to primary parameters");
  const auto given = std::make_shared<Arguments>();
  command
      ->add_option("ratings", given->source.name,
                   "DB, CSV with rater,motion,pair,value, or builtin:A (simulated raters)")
      ->required();
  command->add_option("--set", given->source.set,
                      "The motions that were rated: a file, or builtin:A");
  command->add_option("--predict", given->predict,
                      "A set that nobody rated: its values, from its motion features");
  command->add_option("--instrument", given->source.selection.instrument,
                      "DB: only the answers of this questionnaire, whatever its items");
  command->add_flag("--include-simulated", given->source.selection.include_simulated,
                    "DB: simulated participants, too");
  command->add_flag("--include-pilot", given->source.selection.include_pilot,
                    "DB: pilot sessions, too");
  command->add_option("--clusters", given->options.clusters, "Primary parameters")
      ->check(CLI::Range(1, 100));
  command->add_option("--least-extreme", given->options.least_extreme, "mu* that a pair needs");
  command->add_option("--most-deviation", given->options.most_deviation, "sigma that it may have");
  command->add_flag("--flip", given->options.flip, "Turn pairs that run against their cluster");
  command->add_flag("--csv", given->csv, "A row for each pair");
  command->add_flag("--json", given->json, "One JSON document (as without it)")->excludes("--csv");
  command->callback([given] { show(*given); });
}

}  // namespace promenade::app
