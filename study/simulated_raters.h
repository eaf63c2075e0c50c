// Raters who are not people: they know how each built-in walk was meant
// (motion/style_character.h) and judge that, each with a leaning and a hand of their own.
// The default adjective models of the built-in sets come from them until people rate; what
// they say is marked simulated wherever it shows (docs/methods.md, 8).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/ratings.h"

namespace promenade::study {

struct RaterOptions {
  int raters = 14;  // as many as [O] asked
  std::uint64_t seed = 1;
  double leaning = 0.2;    // standard deviation of what a rater adds to all motions on a pair
  double boldness = 0.15;  // the same of the logarithm of how far from 0 a rater goes
};

// A value of the five-point scale for every rater, cycle of the built-in set ("A") and
// pair of the source; nothing for a set that is not built in. The same seed gives the
// same ratings on every machine.
std::optional<RatingsTable> simulated_ratings(const std::string& set, const RaterOptions& = {});

// "14 simulated raters, seed 1"
std::string describe(const RaterOptions& options);

}  // namespace promenade::study
