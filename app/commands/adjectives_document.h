// What `promenade model adjectives` says: a JSON document, and a table of the pairs.
#pragma once

#include <optional>
#include <string>

#include "app/commands/rating_source.h"
#include "app/print.h"

namespace promenade::app {

// `others`: a set that nobody rated, whose values are told from its features; null: none.
// Predictions are there where `rated` knows its motions, and has at least three and a kept pair.
Json adjectives_document(const RatedSet& rated, const motion::MotionSet* others);
bool can_predict(const RatedSet& rated);

// A row for each pair.
std::string adjectives_csv(const study::AdjectiveModel& model);

}  // namespace promenade::app
