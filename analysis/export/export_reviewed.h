// The free answers that somebody read and found fit to be published.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "study/sqlite.h"

namespace promenade::analysis {

// session (as in the database), instrument, item, and the answer itself.
using ReviewedAnswers = std::set<std::tuple<std::string, std::string, std::string, std::string>>;

// A CSV whose first row names the columns; session, instrument, item and text must be among
// them: the table of answers of an export without --public, with the other rows taken away.
// Throws InputError with all wrong rows; one that is no answer of the database is wrong.
ReviewedAnswers parse_reviewed(const std::string& file, std::string_view text,
                               study::Database& database);

}  // namespace promenade::analysis
