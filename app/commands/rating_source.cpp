#include "app/commands/rating_source.h"

#include <fmt/format.h>

#include "app/print.h"
#include "motion/builtin.h"
#include "motion/did_you_mean.h"
#include "motion/files.h"
#include "motion/problem.h"
#include "study/adjective_model_file.h"
#include "study/ratings_csv.h"
#include "study/study.h"

namespace promenade::app {
namespace {

RatedSet rated_builtin(const RatingSource& source, const std::string& builtin) {
  if (!source.set.empty())
    throw InputError("--set", "the ratings of a built-in set are of its own motions");
  motion::MotionSet set = study::load_motion_set(source.name, "");
  auto model = study::builtin_adjective_model(builtin);
  if (!model) throw InputError(source.name, "nobody knows how its walks were meant");
  return {std::move(*model), std::move(set)};
}

RatedSet rated_file(const RatingSource& source) {
  std::optional<motion::MotionSet> set;
  if (!source.set.empty()) set = study::load_motion_set(source.set, "");
  const std::string text = read_file(source.name);
  const std::vector<std::string> motions = set ? names_of(*set) : std::vector<std::string>();
  if (text.rfind("SQLite format 3", 0) == 0) {
    study::DatabaseRatings found =
        study::read_database_ratings(source.name, source.selection, set ? &*set : nullptr);
    if (!found.stimuli.empty())
      print_note(source.name +
                 ": left out the ratings of stimuli, which no mixture of the set is: " +
                 quoted_list(found.stimuli));
    return {study::make_adjective_model(std::move(found.table), source.name), std::move(found.set)};
  }
  if (study::is_adjective_model(source.name))
    return {study::read_adjective_model(source.name, text, motions), std::move(set)};
  study::RatingsTable table = study::read_ratings_csv(source.name, text, motions);
  return {study::make_adjective_model(std::move(table), source.name), std::move(set)};
}

// Names of a model file stay while its sliders do.
study::AdjectiveModel with_options(study::AdjectiveModel model, const ModelChoices& choices) {
  motion::QuantificationOptions options = model.options;
  options.least_extreme = choices.least_extreme.value_or(options.least_extreme);
  options.most_deviation = choices.most_deviation.value_or(options.most_deviation);
  options.clusters = choices.clusters.value_or(options.clusters);
  options.flip = options.flip || choices.flip;
  std::vector<study::PrimaryWords> words = std::move(model.words);
  const std::vector<int> before = model.quantification.cluster;
  model = study::make_adjective_model(std::move(model.table), model.source, options);
  if (words.empty() || model.quantification.cluster != before) return model;
  return named(std::move(model), std::move(words));
}

void take_names(const std::string& option, const std::vector<std::string>& names,
                const std::string& language, std::vector<study::PrimaryWords>& words) {
  if (names.empty()) return;
  if (names.size() != words.size()) {
    throw InputError(option, fmt::format("{} names for {} clusters; give one for each, in the "
                                         "order of \"clusters\" in the document",
                                         names.size(), words.size()));
  }
  for (std::size_t c = 0; c < words.size(); ++c) words[c].name[language] = names[c];
}

study::AdjectiveModel with_names(study::AdjectiveModel model, const ModelChoices& choices) {
  if (choices.names.empty() && choices.names_ja.empty()) return model;
  std::vector<study::PrimaryWords> words = words_of(model);
  take_names("--names", choices.names, "en", words);
  take_names("--names-ja", choices.names_ja, "ja", words);
  return named(std::move(model), std::move(words));
}

}  // namespace

RatedSet load_rated_set(const RatingSource& source, const ModelChoices& choices) {
  const auto builtin = motion::builtin_name(source.name);
  RatedSet rated = builtin ? rated_builtin(source, *builtin) : rated_file(source);
  rated.model = with_names(with_options(std::move(rated.model), choices), choices);
  return rated;
}

}  // namespace promenade::app
