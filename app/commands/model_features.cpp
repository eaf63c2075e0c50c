// `promenade model features`: the 51 features of a set, and the sliders made of them.
#include <fmt/format.h>

#include <memory>

#include "app/commands/adjectives_parts.h"
#include "app/commands/model_parts.h"
#include "app/commands/model_pictures.h"
#include "app/commands/numbers.h"
#include "app/model_window.h"
#include "app/print.h"
#include "motion/models/control_maps.h"
#include "motion/models/features.h"
#include "study/study.h"

namespace promenade::app {
namespace {

constexpr int usual_clusters = 4;

struct Arguments {
  std::string set, picture;
  int clusters = usual_clusters;
  bool json = false, csv = false, window = false;
};

std::vector<std::string> feature_list() {
  const auto names = motion::feature_names();
  return {names.begin(), names.end()};
}

std::string features_csv(const motion::MotionSet& set) {
  const Eigen::MatrixXd values = motion::motion_features(set);
  std::string text = "name";
  for (const std::string_view feature : motion::feature_names())
    text += fmt::format(",{}", feature);
  text += "\n";
  for (int i = 0; i < set.size(); ++i) {
    text += csv_cell(set.cycles[static_cast<std::size_t>(i)].name);
    for (const double value : values.col(i)) text += fmt::format(",{}", value);
    text += "\n";
  }
  return text;
}

void put_sliders(const motion::FeatureSliders& sliders, Json& document) {
  document["clusters"] = sliders.cluster;  // of each feature
  document["sliders"] = Json::array();
  for (std::size_t c = 0; c < sliders.names.size(); ++c) {
    document["sliders"].push_back(
        {{"name", sliders.names[c]},
         {"agreement", sliders.agreement[c]},
         {"values", to_list(sliders.parameters.row(static_cast<Eigen::Index>(c)).transpose())}});
  }
  document["merges"] = merges_json(sliders.tree);
  document["printed"] = {
      {"set_b",
       comparison_json(sliders.cluster, motion::printed_feature_clusters(), feature_list())}};
}

Json features_document(const motion::MotionSet& set, int clusters) {
  const Eigen::MatrixXd values = motion::motion_features(set);
  Json document = {{"features", feature_list()}, {"units", Json::array()}, {"rows", Json::array()}};
  for (int k = 0; k < motion::feature_count; ++k) {
    document["units"].push_back(motion::feature_unit(k));
  }
  for (int i = 0; i < set.size(); ++i) {
    const motion::Cycle& cycle = set.cycles[static_cast<std::size_t>(i)];
    document["rows"].push_back(
        {{"name", cycle.name}, {"style", cycle.style}, {"values", to_list(values.col(i))}});
  }
  if (set.size() > 1) put_sliders(motion::feature_sliders(set, clusters), document);
  return document;
}

void show(const Arguments& given) {
  const motion::MotionSet set = study::load_motion_set(given.set, "");
  if (set.size() < 2 && (given.window || !given.picture.empty()))
    throw InputError(given.set, "has a single motion; clusters of features need two");
  if (given.window) return edit_in_window(ModelEditor(set, given.clusters), "");
  if (!given.picture.empty()) {
    draw_features(set, given.clusters, given.picture);
    if (!given.json && !given.csv) return;
  }
  if (given.csv) return print_text(features_csv(set));
  print_json(features_document(set, given.clusters));
}

}  // namespace

void add_model_features(Command model) {
  Command command = model.add_subcommand("features", "The 51 motion features of every cycle");
  const auto given = std::make_shared<Arguments>();
  command.add_option("set", given->set, "A file, or builtin:A, B or N").required();
  command.add_option("--clusters", given->clusters, "Sliders that are made of them (4)")
      .range(1, motion::feature_count);
  command.add_option("--picture", given->picture,
                     "Draw the dendrogram instead: FILE.svg, FILE.pdf or FILE.png");
  command.add_flag("--window", given->window, "A window that shows the tree and cuts it");
  command.add_flag("--csv", given->csv, "A row for each cycle");
  command.add_flag("--json", given->json, "One JSON document (as without it)").excludes("--csv");
  command.callback([given] { show(*given); });
}

}  // namespace promenade::app
