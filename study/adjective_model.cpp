#include "study/adjective_model.h"

#include <algorithm>
#include <cassert>

#include "motion/models/cluster_names.h"
#include "motion/models/features.h"
#include "motion/models/ridge.h"
#include "motion/problem.h"
#include "study/simulated_raters.h"

namespace promenade::study {
namespace {

// Of each cluster the pair nearest to its mean.
std::vector<std::string> middle_pairs(const AdjectiveModel& model) {
  const motion::Quantification& q = model.quantification;
  std::vector<std::string> middle(static_cast<std::size_t>(q.primary.rows()));
  std::vector<double> least(middle.size(), INFINITY);
  for (std::size_t i = 0; i < q.cluster.size(); ++i) {
    const auto c = static_cast<std::size_t>(q.cluster[i]);
    const auto row = static_cast<Eigen::Index>(i);
    const double away = (q.scaled.row(row) - q.primary.row(q.cluster[i])).norm();
    if (away >= least[c]) continue;
    least[c] = away;
    middle[c] = model.kept_pairs[i];
  }
  return middle;
}

}  // namespace

AdjectiveModel make_adjective_model(RatingsTable table, const std::string& source,
                                    const motion::QuantificationOptions& options) {
  AdjectiveModel model;
  model.options = options;
  model.source = source;
  model.quantification = motion::quantify(table.ratings, static_cast<int>(table.pairs.size()),
                                          static_cast<int>(table.motions.size()), options);
  for (const int pair : model.quantification.kept) {
    model.kept_pairs.push_back(table.pairs[static_cast<std::size_t>(pair)]);
  }
  for (const motion::ClusterName& name :
       motion::name_clusters(motion::printed_clusters(model.kept_pairs),
                             model.quantification.cluster, middle_pairs(model))) {
    model.names.push_back(name.name);
    model.name_agreement.push_back(name.agreement);
  }
  model.agreement = rater_agreement(table, model.quantification, options);
  model.table = std::move(table);
  return model;
}

AdjectiveModel named(AdjectiveModel model, std::vector<PrimaryWords> words) {
  assert(words.size() == model.names.size() && "a name for each cluster");
  for (std::size_t c = 0; c < words.size(); ++c) model.names[c] = text_in(words[c].name, "en");
  model.words = std::move(words);
  return model;
}

AdjectiveModel reordered(AdjectiveModel model, const std::vector<std::string>& motions) {
  assert(motions.size() == model.table.motions.size() && "the same motions");
  std::vector<int> from, to(motions.size());  // columns, by their new and by their old places
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const auto& old = model.table.motions;
    const auto found = std::find(old.begin(), old.end(), motions[i]) - old.begin();
    from.push_back(static_cast<int>(found));
    to[static_cast<std::size_t>(found)] = static_cast<int>(i);
  }
  motion::Quantification& q = model.quantification;
  for (Eigen::MatrixXd* values : {&q.mean, &q.deviation, &q.scaled, &q.primary}) {
    *values = Eigen::MatrixXd((*values)(Eigen::all, from));
  }
  for (motion::Rating& one : model.table.ratings)
    one.motion = to[static_cast<std::size_t>(one.motion)];
  model.table.motions = motions;
  return model;
}

std::vector<PrimaryWords> words_of(const AdjectiveModel& model) {
  if (!model.words.empty()) return model.words;
  std::vector<PrimaryWords> words;
  for (std::string name : model.names) {
    // A single pair has a slider of its own, under its own name.
    if (const auto dash = name.find('-'); dash != std::string::npos) name.replace(dash, 1, "–");
    words.push_back({{{"en", name}}, {}, {}});
  }
  return words;
}

std::vector<std::string> pairs_of(const AdjectiveModel& model, int cluster) {
  std::vector<std::string> pairs;
  for (std::size_t i = 0; i < model.kept_pairs.size(); ++i) {
    if (model.quantification.cluster[i] == cluster) pairs.push_back(model.kept_pairs[i]);
  }
  return pairs;
}

std::optional<AdjectiveModel> builtin_adjective_model(
    const std::string& set, const motion::QuantificationOptions& options) {
  const RaterOptions raters;
  auto table = simulated_ratings(set, raters);
  if (!table) return std::nullopt;
  return make_adjective_model(std::move(*table), describe(raters), options);
}

PredictedAdjectives predict_adjectives(const AdjectiveModel& model, const motion::MotionSet& rated,
                                       const motion::MotionSet& others) {
  const Eigen::MatrixXd& primary = model.quantification.primary;
  if (rated.size() < 3 || primary.rows() == 0) {
    throw InputError(model.source,
                     "tells nothing about other motions: three rated motions and a "
                     "pair of adjectives that is not dropped are needed");
  }
  const motion::Ridge ridge = motion::fit_ridge(motion::motion_features(rated), primary);
  PredictedAdjectives result{model.names, Eigen::MatrixXd(primary.rows(), others.size()),
                             ridge.error, model.source, model.simulated()};
  for (int i = 0; i < others.size(); ++i) {
    const motion::Cycle& cycle = others.cycles[static_cast<std::size_t>(i)];
    result.primary.col(i) =
        motion::predict(ridge, motion::motion_features(others, cycle)).cwiseMax(0.0).cwiseMin(1.0);
  }
  return result;
}

}  // namespace promenade::study
