// Adjective sliders ([O] 3-4): one for each cluster of pairs of adjectives by which people
// rated the motions of the set; others of the pairs can be added.
#include <algorithm>
#include <cmath>

#include "app/parameter_sliders.h"
#include "app/parameter_sliders_view.h"
#include "app/registry.h"
#include "motion/models/adjective_pairs.h"
#include "study/adjective_model.h"

namespace promenade::app {
namespace {

using motion::PairFate;
using study::AdjectiveModel;

Words adjective(std::string_view word) {
  return {"adjective." + std::string(word), std::string(word)};
}

void name_poles(const std::string& pair, SliderParameter& parameter) {
  const motion::PairWords words = motion::words_of_pair(pair);
  if (!words.left.empty()) parameter.low = adjective(words.left);
  parameter.high = adjective(words.right);
}

// The pair whose words stand at the ends of its cluster's slider: the one that runs most
// like the cluster's mean, of equals the first.
const std::string& representative(const AdjectiveModel& model, Eigen::Index cluster) {
  const motion::Quantification& q = model.quantification;
  std::size_t best = 0;
  double highest = -INFINITY;
  for (std::size_t i = 0; i < model.kept_pairs.size(); ++i) {
    if (q.cluster[i] != cluster) continue;
    const double alike =
        motion::correlation(q.scaled.row(static_cast<Eigen::Index>(i)), q.primary.row(cluster));
    if (alike <= highest) continue;
    highest = alike;
    best = i;
  }
  return model.kept_pairs[best];
}

// What whoever made the model calls it comes first.
void take_words(const study::PrimaryWords& words, SliderParameter& parameter) {
  parameter.title.own = words.name;
  if (!words.low.empty()) parameter.low = Words{"", study::text_in(words.low, "en"), words.low};
  if (!words.high.empty()) parameter.high = Words{"", study::text_in(words.high, "en"), words.high};
}

void add_clusters(const AdjectiveModel& model, SliderCatalogue& catalogue) {
  const Eigen::MatrixXd& primary = model.quantification.primary;
  for (Eigen::Index c = 0; c < primary.rows(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    const std::string& name = model.names[at];
    SliderParameter parameter;
    // A cluster like none of the source has the name of one of its pairs.
    const bool is_pair = model.words.empty() && name.find('-') != std::string::npos;
    parameter.name = is_pair ? "cluster:" + name : name;
    if (!is_pair) parameter.title = {"cluster." + name, name};
    name_poles(representative(model, c), parameter);
    if (!model.words.empty()) take_words(model.words[at], parameter);
    catalogue.parameters.push_back(std::move(parameter));
    catalogue.values.row(c) = primary.row(c);
  }
  catalogue.primary = static_cast<int>(primary.rows());
}

void add_pairs(const AdjectiveModel& model, bool kept, SliderCatalogue& catalogue) {
  const motion::Quantification& q = model.quantification;
  for (std::size_t j = 0; j < model.table.pairs.size(); ++j) {
    if (q.fate[j] == PairFate::unrated || (q.fate[j] == PairFate::kept) != kept) continue;
    SliderParameter parameter;
    parameter.name = model.table.pairs[j];
    name_poles(parameter.name, parameter);
    catalogue.values.row(static_cast<Eigen::Index>(catalogue.parameters.size())) =
        (q.mean.row(static_cast<Eigen::Index>(j)).array() + 2) / 4;
    catalogue.parameters.push_back(std::move(parameter));
  }
}

std::shared_ptr<SliderCatalogue> make_catalogue(const AdjectiveModel& model) {
  auto catalogue = std::make_shared<SliderCatalogue>();
  const motion::Quantification& q = model.quantification;
  const auto unrated = std::count(q.fate.begin(), q.fate.end(), PairFate::unrated);
  const auto pairs = static_cast<Eigen::Index>(model.table.pairs.size()) - unrated;
  catalogue->values.resize(q.primary.rows() + pairs, q.primary.cols());
  const auto begin = [&](const char* heading) {
    catalogue->sections.push_back({heading, static_cast<int>(catalogue->parameters.size())});
  };
  begin("sliders.primary");
  add_clusters(model, *catalogue);
  begin("interface.adjectives.agreed");
  add_pairs(model, true, *catalogue);
  begin("interface.adjectives.others");
  add_pairs(model, false, *catalogue);
  return catalogue;
}

study::PreparedModel prepare(const study::InterfaceResources& resources,
                             const study::Parameters& parameters) {
  const auto model = resources.adjectives();
  if (!model) {
    return {nullptr,
            "nobody has rated the motions of this set; name a file of ratings with ratings = "
            "\"...\" in [study]"};
  }
  if (model->table.motions != motion::names_of(resources.space.set)) {
    return {nullptr, "the ratings are of other motions"};
  }
  if (model->quantification.primary.rows() == 0) return {nullptr, describe(model->agreement)};
  auto catalogue = make_catalogue(*model);
  read_slider_parameters(parameters, *catalogue);
  return {catalogue, ""};
}

const InterfaceEntry entry{{
    .name = "adjectives",
    .sentence =
        "Sliders between opposite adjectives, by ratings of the motions; pairs of adjectives "
        "can be added, changed and taken away.",
    .parameters = slider_parameter_specs(),
    .texts = slider_texts({"interface.adjectives.title", "interface.adjectives.hint",
                           "interface.adjectives.agreed", "interface.adjectives.others"}),
    .prepare = prepare,
    .start = start_as<ParameterSliders>,
    .simulate = simulate_sliders,
    .draw = draw_sliders,
}};

}  // namespace
}  // namespace promenade::app
