// Lists of targets of equal difficulty: with deal = "rotated" each interface gets one of them,
// another one from person to person (docs/methods.md, 3).
#pragma once

#include <vector>

namespace promenade::study {

// Indices of the targets in as many lists as asked for, equally many in each: sorted by their
// difficulty (of equals the first comes first), dealt to and fro. Their number is a multiple
// of `lists`.
std::vector<std::vector<int>> deal_lists(const std::vector<double>& difficulties, int lists);

}  // namespace promenade::study
