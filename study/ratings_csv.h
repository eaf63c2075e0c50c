// Ratings of motions as a table of rater, motion, pair and value: in and out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/ratings.h"

namespace promenade::study {

// Reads CSV with a header that names the columns rater, motion, pair and value (-2 to 2).
// `motions`: those that may occur, in the order wanted; empty: any. A rater whose name
// begins with "simulated" makes the table a simulated one. Throws InputError with all
// problems at once.
RatingsTable read_ratings_csv(const std::string& file, std::string_view text,
                              const std::vector<std::string>& motions);

// "1", or "simulated-01" of a table by simulated raters: the first rater is number 0.
std::string rater_name(int rater, bool simulated);

// The same table: raters by their numbers, "simulated-01" where they are.
std::string ratings_csv(const RatingsTable& table);

}  // namespace promenade::study
