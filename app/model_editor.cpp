#include "app/model_editor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/both_words.h"
#include "motion/models/control_maps.h"
#include "motion/models/features.h"

namespace promenade::app {
namespace {

constexpr int most_clusters = 100;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::string fate_text(motion::PairFate fate) {
  static constexpr const char* texts[] = {"kept", "mu* low", "sigma high", "not rated"};
  return texts[static_cast<int>(fate)];
}

}  // namespace

ModelEditor::ModelEditor(study::AdjectiveModel model)
    : title_("Adjectives from " + model.source), model_(std::move(model)) {
  for (std::size_t c = 0; c < model_->words.size(); ++c) {
    given_[pairs_of(*model_, static_cast<int>(c))] = model_->words[c];
  }
  show_model();
}

ModelEditor::ModelEditor(const motion::MotionSet& set, int clusters)
    : title_("Features of " + set.name), set_(set) {
  show_features(clusters);
}

double ModelEditor::top() const {
  return tree_.merges.empty() ? 1 : std::max(1e-9, 1.06 * tree_.merges.back().height);
}

void ModelEditor::cut_at(double height) {
  const double wanted = std::clamp(height, 0.0, top());
  const int clusters = std::min(most_clusters, motion::clusters_at(tree_, wanted));
  if (clusters != static_cast<int>(names_.size()) && !leaves_.empty()) {
    if (model_) {
      motion::QuantificationOptions options = model_->options;
      options.clusters = clusters;
      remake(options);
    } else {
      show_features(clusters);
    }
  }
  cut_ = wanted;
}

void ModelEditor::set_thresholds(double least_extreme, double most_deviation) {
  if (!model_) return;
  motion::QuantificationOptions options = model_->options;
  options.least_extreme = least_extreme;
  options.most_deviation = most_deviation;
  remake(options);
}

void ModelEditor::rename(int cluster, const std::string& name) {
  if (!model_) return;
  std::vector<study::PrimaryWords> words = words_of(*model_);
  study::PrimaryWords& one = words[static_cast<std::size_t>(cluster)];
  if (study::text_in(one.name, "en") == name) return;
  one.name = {{"en", name}};  // a translation was of the name before
  given_[pairs_of(*model_, cluster)] = one;
  remake(model_->options);
}

void ModelEditor::remake(const motion::QuantificationOptions& options) {
  *model_ = study::make_adjective_model(std::move(model_->table), model_->source, options);
  std::vector<study::PrimaryWords> words = words_of(*model_);
  bool any = false;
  for (std::size_t c = 0; c < words.size(); ++c) {
    const auto found = given_.find(pairs_of(*model_, static_cast<int>(c)));
    if (found == given_.end()) continue;
    words[c] = found->second;
    any = true;
  }
  if (any) *model_ = named(std::move(*model_), std::move(words));
  show_model();
}

void ModelEditor::show_model() {
  const motion::Quantification& q = model_->quantification;
  tree_ = q.tree;
  layout_ = motion::dendrogram_layout(tree_);
  cluster_ = q.cluster;
  names_.clear();
  for (const study::PrimaryWords& words : words_of(*model_)) {
    names_.push_back(study::text_in(words.name, "en"));
  }
  leaves_.clear();
  for (const std::string& pair : model_->kept_pairs) leaves_.push_back(both_words(pair));
  rows_.clear();
  std::size_t kept = 0;
  for (std::size_t j = 0; j < model_->table.pairs.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    const bool stays = q.fate[j] == motion::PairFate::kept;
    rows_.push_back({both_words(model_->table.pairs[j]), q.extreme(row), q.disagreement(row),
                     fate_text(q.fate[j]), stays ? q.cluster[kept] : -1});
    if (stays) ++kept;
  }
  cut_ = motion::cut_height(tree_, std::max(1, static_cast<int>(names_.size())));
}

void ModelEditor::show_features(int clusters) {
  const motion::FeatureSliders sliders = motion::feature_sliders(*set_, clusters);
  tree_ = sliders.tree;
  layout_ = motion::dendrogram_layout(tree_);
  cluster_ = sliders.cluster;
  names_ = sliders.names;
  const auto features = motion::feature_names();
  leaves_.assign(features.begin(), features.end());
  rows_.clear();
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    const int cluster = cluster_[k];
    rows_.push_back(
        {leaves_[k], unknown, unknown, names_[static_cast<std::size_t>(cluster)], cluster});
  }
  cut_ = motion::cut_height(tree_, static_cast<int>(names_.size()));
}

}  // namespace promenade::app
