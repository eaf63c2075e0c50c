// The power of the two-sided paired t test.
#pragma once

#include <optional>

namespace promenade::analysis {

// P(|t'| > t), t' of the non-central t distribution with n - 1 degrees of freedom and
// non-centrality delta sqrt(n) / sd, t the quantile of Student's at 1 - alpha/2: both tails
// count. n: pairs, nothing for less than 2; delta: mean difference; sd > 0: of the differences;
// 0 < alpha < 1. Absolute error below 1e-7.
std::optional<double> power_paired_t(int n, double delta, double sd, double alpha);

}  // namespace promenade::analysis
