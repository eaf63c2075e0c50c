#include "app/commands/model_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/pictures/dendrogram_picture.h"
#include "app/both_words.h"
#include "motion/models/control_maps.h"
#include "motion/models/features.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

using analysis::DendrogramPicture;

std::string why_dropped(const study::AdjectiveModel& model, int pair) {
  const motion::Quantification& q = model.quantification;
  if (q.fate[static_cast<std::size_t>(pair)] == motion::PairFate::unrated) return "not rated";
  std::string why;
  if (q.extreme(pair) < model.options.least_extreme)
    why = fmt::format("mu* {:.2f} < {}", q.extreme(pair), model.options.least_extreme);
  if (q.disagreement(pair) > model.options.most_deviation) {
    why += fmt::format("{}sigma {:.2f} > {}", why.empty() ? "" : ", ", q.disagreement(pair),
                       model.options.most_deviation);
  }
  return why;
}

}  // namespace

void draw_adjectives(const study::AdjectiveModel& model, const std::filesystem::path& file) {
  if (model.kept_pairs.empty()) throw InputError(model.source, describe(model.agreement));
  DendrogramPicture picture;
  picture.title =
      fmt::format("{} pairs of adjectives, {} motions, {} raters", model.kept_pairs.size(),
                  model.table.motions.size(), model.table.raters);
  if (model.simulated()) picture.warnings.emplace_back("Simulated raters: no person has judged");
  if (!model.agreement.agrees()) picture.warnings.emplace_back("The ratings do not agree");
  picture.tree = model.quantification.tree;
  picture.cluster = model.quantification.cluster;
  picture.names = model.names;
  for (std::string& name : picture.names) {
    if (model.words.empty()) name = both_words(name);
  }
  for (const std::string& pair : model.kept_pairs) picture.leaves.push_back(both_words(pair));
  for (int j = 0; j < static_cast<int>(model.table.pairs.size()); ++j) {
    const auto at = static_cast<std::size_t>(j);
    if (model.quantification.fate[at] == motion::PairFate::kept) continue;
    picture.dropped.push_back(both_words(model.table.pairs[at]) + ": " + why_dropped(model, j));
  }
  draw_dendrogram(picture, file);
}

void draw_features(const motion::MotionSet& set, int clusters, const std::filesystem::path& file) {
  const motion::FeatureSliders sliders = motion::feature_sliders(set, clusters);
  DendrogramPicture picture;
  picture.title =
      fmt::format("{} features of {} motions ({})", motion::feature_count, set.size(), set.name);
  picture.tree = sliders.tree;
  picture.cluster = sliders.cluster;
  picture.names = sliders.names;
  const auto names = motion::feature_names();
  picture.leaves.assign(names.begin(), names.end());
  draw_dendrogram(picture, file);
}

}  // namespace promenade::app
