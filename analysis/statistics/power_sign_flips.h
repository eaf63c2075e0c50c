// The power of the two-sided signed-rank test, exactly, where each of n differences without
// ties is positive with the same probability, whatever its magnitude.
#pragma once

#include <cstdint>
#include <optional>

namespace promenade::analysis {

// The largest T = min(W+, W-) that is rejected at level alpha: 2 P(W+ <= T) <= alpha. Nothing
// where none is. n: 0 to sign_flips_limit; 0 < alpha < 1.
std::optional<std::int64_t> critical_rank_sum(int n, double alpha);

// The same by the normal approximation without correction: 2 Phi(-|z|) <= alpha.
std::optional<std::int64_t> critical_rank_sum_normal(int n, double alpha);

// P(T <= critical), each sign + with probability p_plus, by dynamic programming; 0 for nothing.
// `critical` is below n (n + 1) / 4.
double sign_flip_power(int n, double p_plus, std::optional<std::int64_t> critical);

}  // namespace promenade::analysis
