// Ratings of motions by people, as a table of rater, motion, pair and value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/models/adjectives.h"

namespace promenade::app {

struct RatingsTable {
  std::vector<std::string> motions;  // by name, unless an order was given
  std::vector<std::string> pairs;    // the 41 of the source first, in their order
  int raters = 0;
  std::vector<motion::Rating> ratings;
};

// Reads CSV with a header that names the columns rater, motion, pair and value (-2 to 2).
// `motions`: those that may occur, in the order wanted; empty: any. Throws InputError
// with all problems at once.
RatingsTable read_ratings(const std::string& file, std::string_view text,
                          const std::vector<std::string>& motions);

}  // namespace promenade::app
