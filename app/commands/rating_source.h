// Where adjective models come from on the command line: a study's database, a table of
// ratings, a model file, or the simulated raters of a built-in set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/adjective_model.h"

namespace promenade::app {

struct RatingSource {
  std::string name;  // DB, RATINGS.csv, MODEL.toml or builtin:A
  std::string set;   // the motions that were rated; empty: those of the source, if it knows
  study::RatingSelection selection;  // of a database
};

// What was said of the model; the rest is as a model file has it, or the standard.
struct ModelChoices {
  std::optional<double> least_extreme, most_deviation;
  std::optional<int> clusters;
  bool flip = false;
  std::vector<std::string> names, names_ja;  // of the sliders, in the order of the clusters
};

struct RatedSet {
  study::AdjectiveModel model;
  std::optional<motion::MotionSet> set;  // the motions, in the order of the model's
};

// Throws InputError.
RatedSet load_rated_set(const RatingSource& source, const ModelChoices& choices = {});

}  // namespace promenade::app
