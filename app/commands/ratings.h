// Ratings of motions by people, as a table of rater, motion, pair and value.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/ratings.h"

namespace promenade::app {

// Reads CSV with a header that names the columns rater, motion, pair and value (-2 to 2).
// `motions`: those that may occur, in the order wanted; empty: any. A rater whose name
// begins with "simulated" makes the table a simulated one. Throws InputError with all
// problems at once.
study::RatingsTable read_ratings(const std::string& file, std::string_view text,
                                 const std::vector<std::string>& motions);

}  // namespace promenade::app
