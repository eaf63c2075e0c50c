// McNemar's test of two paired yes/no outcomes, such as failing with one interface
// and with another (McNemar 1947; mid-p: Fagerland, Lydersen & Laake 2013).
#pragma once

#include <optional>

namespace promenade::analysis {

struct McNemarTest {
  double p_exact = 1, p_mid = 1;
  // Nothing where nobody changed.
  std::optional<double> chi2, p_chi2;
  std::optional<double> chi2_corrected, p_chi2_corrected;  // by 1 (Edwards), never below 0
};

// first_only, second_only: how many said yes to just that one of the two.
McNemarTest mcnemar(int first_only, int second_only);

}  // namespace promenade::analysis
