// Cochran's Q test (Cochran 1950): do people say yes (fail, succeed) equally often
// under several conditions?
#pragma once

#include <optional>
#include <vector>

namespace promenade::analysis {

struct CochranTest {
  int n = 0, k = 0;                // subjects and conditions
  std::vector<int> column_totals;  // how many said yes
  // Nothing where everyone says the same under all conditions.
  std::optional<double> q, p;     // p by chi-square with k - 1 degrees of freedom
  std::optional<double> p_exact;  // see row_permutations.h; nothing where that is too much
};

// yes[subject][condition]; at least one subject and condition, rows of equal length.
CochranTest cochran_q(const std::vector<std::vector<bool>>& yes);

}  // namespace promenade::analysis
