// The name that someone probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace promenade {

// Letters to add, drop, replace or swap with their neighbour to get from a to b
// (restricted Damerau-Levenshtein distance, bytes).
int edit_distance(std::string_view a, std::string_view b);

// The candidate that is nearest to `name`, if it is near enough to be meant (a third
// of its letters), of equals the one that begins most like it; empty: none. Names of more than
// 80 letters are like no other, and of more than 2000 candidates the first are asked.
std::string closest_name(std::string_view name, const std::vector<std::string>& candidates);

// The same whatever the case of the letters.
std::string closest_name_of_any_case(std::string_view name,
                                     const std::vector<std::string>& candidates);

// "; did you mean \"limit_s\"?", or nothing: to be put behind a problem.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

// "\"match\", \"find\"": for sentences about what is allowed.
std::string quoted_list(const std::vector<std::string>& names);

}  // namespace promenade
