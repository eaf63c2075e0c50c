// The distribution behind the tests of Friedman and Cochran: the scores of each
// subject stand under the conditions in any order, all orders alike.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace promenade::analysis {

// Up to so many conditions and subjects the orders are counted.
inline constexpr std::size_t row_permutations_conditions = 3;
inline constexpr std::size_t row_permutations_subjects = 100;

// scores[subject][condition], none negative. P(the squares of the column totals sum to at
// least what they do in `scores`), by dynamic programming over the totals; nothing beyond
// the limits above.
std::optional<double> row_permutation_tail(const std::vector<std::vector<int>>& scores);

}  // namespace promenade::analysis
