// The distribution behind the signed-rank test: every rank enters a sum with
// probability 1/2, independently. By dynamic programming, exact but for the
// rounding of sums of positive numbers, so that probabilities of 1e-200 keep
// their digits. Start here to understand the tests.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace promenade::analysis {

// Above this many ranks the counts would leave the range of a double.
inline constexpr std::size_t sign_flips_limit = 2000;

// P(S = s) for s = 0..last, S the sum of those `ranks` (positive whole numbers,
// so midranks come doubled) that are chosen. At most sign_flips_limit ranks.
// Takes O(ranks x last) time.
std::vector<double> sign_flip_distribution(std::vector<std::int64_t> ranks, std::int64_t last);

struct SignFlipTail {
  double below = 0;  // P(S < last)
  double at = 0;     // P(S = last)
};

// The same where only the tail is asked for, several times faster: the ranks are dealt to two
// halves, whose distributions are symmetric and meet at `last`. From last = 0.
SignFlipTail sign_flip_tail(std::vector<std::int64_t> ranks, std::int64_t last);

}  // namespace promenade::analysis
