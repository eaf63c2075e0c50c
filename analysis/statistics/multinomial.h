// Are several choices taken equally often? The exact multinomial test.
#pragma once

#include <optional>
#include <vector>

namespace promenade::analysis {

// Up to so many ways to share n choices without regard to order are counted.
inline constexpr double multinomial_limit = 2e6;

struct EqualChoices {
  // The probability of all counts that are at most as likely as these, where each choice has
  // probability 1/k; likelihoods within 1e-7 are equal. Nothing beyond the limit above.
  std::optional<double> p_exact;
  double chi2 = 0;  // Pearson 1900: sum (count - n/k)^2 / (n/k)
  double p_chi2 = 1;
};

// At least two counts, none negative, one positive.
EqualChoices equal_choices(const std::vector<int>& counts);

}  // namespace promenade::analysis
