// Differences of paired data, fit for ranking.
#pragma once

#include <optional>
#include <vector>

namespace promenade::analysis {

struct Differences {
  std::vector<double> values;  // x - y of the complete pairs, in their order
  int missing = 0;             // pairs in which x or y was missing
};

// Binary rounding breaks ties (0.3 - 0.1 is not 0.7 - 0.5). So magnitudes that
// differ by less than 1e-9 of the largest |x| or |y| are made equal, and those
// below it zero. Differences that were measured as such need none of this.
// x and y have the same length.
Differences paired_differences(const std::vector<std::optional<double>>& x,
                               const std::vector<std::optional<double>>& y);

}  // namespace promenade::analysis
