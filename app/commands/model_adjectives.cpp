#include "app/commands/model_adjectives.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/commands/numbers.h"
#include "app/commands/ratings.h"
#include "app/print.h"
#include "motion/files.h"
#include "motion/models/adjective_pairs.h"
#include "motion/models/features.h"
#include "motion/models/ridge.h"
#include "study/study.h"

namespace promenade::app {
namespace {

using Eigen::Index;

struct Arguments {
  std::string ratings, set;
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

Json pairs_json(const RatingsTable& table, const motion::Quantification& q,
                const motion::QuantificationOptions& options) {
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
                 {"reason", motion::to_text(q.fate[j], options)},
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

// How well the features of a motion tell its primary parameters.
Json prediction_json(const motion::MotionSet& set, const motion::Quantification& q) {
  const motion::Ridge ridge = motion::fit_ridge(motion::motion_features(set), q.primary);
  Json left_out = Json::array();
  for (Index c = 0; c < ridge.left_out.rows(); ++c) left_out.push_back(row_json(ridge.left_out, c));
  return {{"penalty", ridge.penalty},
          {"left_out", left_out},
          {"left_out_error", std::vector<double>(ridge.error.begin(), ridge.error.end())},
          {"error_of_the_mean",
           std::vector<double>(ridge.baseline_error.begin(), ridge.baseline_error.end())}};
}

std::string pairs_csv(const RatingsTable& table, const motion::Quantification& q) {
  std::string text = "pair,mu_star,sigma,fate,cluster\n";
  std::size_t kept = 0;
  for (std::size_t j = 0; j < table.pairs.size(); ++j) {
    const bool stays = q.fate[j] == motion::PairFate::kept;
    const auto row = static_cast<Index>(j);
    const auto cell = [](double v) { return std::isnan(v) ? std::string() : fmt::format("{}", v); };
    text += fmt::format("{},{},{},{},{}\n", csv_cell(table.pairs[j]), cell(q.extreme(row)),
                        cell(q.disagreement(row)), fate_name(q.fate[j]),
                        stays ? fmt::format("{}", q.cluster[kept++]) : std::string());
  }
  return text;
}

void show(const Arguments& given) {
  const std::string text = read_file(given.ratings);
  if (text.rfind("SQLite format 3", 0) == 0) {
    throw OutsideError(given.ratings +
                       ": ratings from a database are not in this version yet; give them as CSV "
                       "with the columns rater,motion,pair,value");
  }
  motion::MotionSet set;
  std::vector<std::string> names;
  if (!given.set.empty()) set = study::load_motion_set(given.set, "");
  for (const motion::Cycle& cycle : set.cycles) names.push_back(cycle.name);
  const RatingsTable table = read_ratings(given.ratings, text, names);
  const motion::Quantification q =
      motion::quantify(table.ratings, static_cast<int>(table.pairs.size()),
                       static_cast<int>(table.motions.size()), given.options);
  if (given.csv) return print_text(pairs_csv(table, q));
  Json primary = Json::array();
  for (Index c = 0; c < q.primary.rows(); ++c) primary.push_back(row_json(q.primary, c));
  Json document = {{"raters", table.raters},
                   {"motions", table.motions},
                   {"pairs", pairs_json(table, q, given.options)},
                   {"merges", merges_json(q.tree)},
                   {"primary", primary},
                   {"prediction", nullptr}};
  if (set.size() >= 3 && q.primary.rows() > 0) document["prediction"] = prediction_json(set, q);
  print_json(document);
}

}  // namespace

void add_model_adjectives(CLI::App& model) {
  auto* command =
      model.add_subcommand("adjectives", "From ratings of motions to primary parameters");
  const auto given = std::make_shared<Arguments>();
  command->add_option("ratings", given->ratings, "CSV: rater,motion,pair,value")->required();
  command->add_option("--set", given->set, "The motions that were rated: a file, or builtin:A");
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
