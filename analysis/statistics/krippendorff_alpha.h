// Krippendorff's alpha (Krippendorff 2011): how far do raters agree, where each rated only
// some of the units?
#pragma once

#include <optional>
#include <vector>

namespace promenade::analysis {

// 1 - observed / expected disagreement, by scale of the ratings. The squared differences:
//   nominal   1 for different values
//   ordinal   (n_c/2 + those between + n_k/2)^2, n how often each value was given
//   interval  (c - k)^2
//   ratio     ((c - k)/(c + k))^2
// Nothing where all ratings are equal, or c + k is 0 for different ones.
struct KrippendorffAlpha {
  int pairable = 0;  // ratings of units that at least two raters rated; others do not count
  std::optional<double> nominal, ordinal, interval, ratio;
};

// ratings[rater][unit], finite, rows of equal length.
KrippendorffAlpha krippendorff_alpha(
    const std::vector<std::vector<std::optional<double>>>& ratings);

}  // namespace promenade::analysis
