#include <fmt/format.h>

#include <memory>

#include "app/commands/adjectives_document.h"
#include "app/commands/model_parts.h"
#include "app/commands/model_pictures.h"
#include "app/model_file.h"
#include "app/model_window.h"
#include "app/print.h"
#include "motion/files.h"
#include "study/adjective_model_file.h"
#include "study/study.h"

namespace promenade::app {
namespace {

struct Arguments {
  RatingSource source;
  std::string predict, out, picture;
  ModelChoices choices;
  bool json = false, csv = false, window = false;
};

void refuse_prediction(const RatedSet& rated) {
  if (!rated.set)
    throw InputError("--predict", "needs the motions that were rated: name them with --set");
  if (!can_predict(rated))
    throw InputError("--predict", "needs three rated motions and a pair that is not dropped");
}

void refuse_ending(const std::string& file) {
  if (!study::is_adjective_model(file)) throw InputError("--out", "a model file ends in .toml");
}

void write_model(const study::AdjectiveModel& model, const std::string& file) {
  refuse_ending(file);
  write_file(file, model_file(model));
  print_note(fmt::format("{}: {} sliders of {} pairs, from {}{}", file, model.names.size(),
                         model.kept_pairs.size(), model.source,
                         model.simulated() ? ": simulated raters, no person has judged" : ""));
}

void run(const Arguments& given) {
  const RatedSet rated = load_rated_set(given.source, given.choices);
  if (!given.predict.empty()) refuse_prediction(rated);
  if (given.window) {
    if (!given.out.empty()) refuse_ending(given.out);
    return edit_in_window(ModelEditor(rated.model), given.out);
  }
  if (!given.out.empty()) write_model(rated.model, given.out);
  if (!given.picture.empty()) draw_adjectives(rated.model, given.picture);
  if (given.csv) return print_text(adjectives_csv(rated.model));
  const bool written = !given.out.empty() || !given.picture.empty();
  if (written && !given.json) return;
  std::optional<motion::MotionSet> others;
  if (!given.predict.empty()) others = study::load_motion_set(given.predict, "");
  print_json(adjectives_document(rated, others ? &*others : nullptr));
  if (!rated.model.agreement.agrees())
    print_note(rated.model.source + ": " + describe(rated.model.agreement));
}

void add_choices(Command command, ModelChoices& choices) {
  command.add_option("--clusters", choices.clusters, "Primary parameters (4)").range(1, 100);
  command.add_option("--least-extreme", choices.least_extreme, "mu* that a pair needs (1)")
      .range(0.0, 2.0);
  command.add_option("--most-deviation", choices.most_deviation, "sigma that it may have (0.85)")
      .range(0.0, 4.0);
  command.add_flag("--flip", choices.flip, "Turn pairs that run against their cluster");
  command
      .add_option("--names", choices.names, "Of the sliders, in the order of the clusters: a,b,c")
      .delimiter(',');
  command.add_option("--names-ja", choices.names_ja, "The same in Japanese").delimiter(',');
}

}  // namespace

void add_model_adjectives(Command model) {
  Command command =
      model.add_subcommand("adjectives", "From ratings of motions to primary parameters");
  const auto given = std::make_shared<Arguments>();
  command
      .add_option(
          "ratings", given->source.name,
          "DB, CSV with rater,motion,pair,value, MODEL.toml, or builtin:A (simulated raters)")
      .required();
  command.add_option("--set", given->source.set,
                     "The motions that were rated: a file, or builtin:A");
  command.add_option("--predict", given->predict,
                     "A set that nobody rated: its values, from its motion features");
  command.add_option("--instrument", given->source.selection.instrument,
                     "DB: only the answers of this questionnaire, whatever its items");
  command.add_flag("--include-simulated", given->source.selection.include_simulated,
                   "DB: simulated participants, too");
  command.add_flag("--include-pilot", given->source.selection.include_pilot,
                   "DB: pilot sessions, too");
  add_choices(command, given->choices);
  command.add_option("--out", given->out, "Write the model, for `ratings` in [study]: MODEL.toml");
  command.add_option("--picture", given->picture,
                     "Draw the dendrogram: FILE.svg, FILE.pdf or FILE.png");
  command.add_flag("--window", given->window,
                   "A window to cut the tree, name the clusters and save them to --out");
  command.add_flag("--csv", given->csv, "A row for each pair");
  command.add_flag("--json", given->json, "One JSON document (as without it)").excludes("--csv");
  command.callback([given] { run(*given); });
}

}  // namespace promenade::app
