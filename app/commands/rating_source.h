// Where adjective models come from on the command line: a study's database, a table of
// ratings, or the simulated raters of a built-in set.
#pragma once

#include <optional>
#include <string>

#include "study/adjective_model.h"

namespace promenade::app {

struct RatingSource {
  std::string name;  // DB, RATINGS.csv or builtin:A
  std::string set;   // the motions that were rated; empty: those of the source, if it knows
  study::RatingSelection selection;  // of a database
};

struct RatedSet {
  study::AdjectiveModel model;
  std::optional<motion::MotionSet> set;  // the motions, in the order of the model's
};

// Throws InputError.
RatedSet load_rated_set(const RatingSource& source, const motion::QuantificationOptions& options);

}  // namespace promenade::app
