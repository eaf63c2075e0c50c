// Wilcoxon's signed-rank test for paired data (Wilcoxon 1945; Pratt 1959 for
// zeros), docs/methods.md, 6. Ranks are midranks of |d|; W+ is the sum of the ranks of
// positive differences. The exact p belongs to the conditional distribution of
// W+ given the ranks: every assignment of signs to the non-zero ranks is
// equally likely. So it holds with ties.
#pragma once

#include <optional>
#include <vector>

#include "analysis/statistics/sign_flips.h"

namespace promenade::analysis {

enum class Zeros {
  drop,   // leave zeros out, then rank (Wilcoxon)
  pratt,  // rank with the zeros, then leave their ranks out
};

// greater: W+ this large or larger; less: this small or smaller;
// two = min(1, 2 min(greater, less)).
struct Tails {
  double two = 1;
  double greater = 1;
  double less = 1;
};

struct SignedRankTest {
  int n = 0;  // differences, zeros included
  int n_zero = 0;
  int n_positive = 0;
  int n_negative = 0;
  int n_tied = 0;      // non-zero differences that share their |d| with another one
  double tie_sum = 0;  // sum of t^3 - t over groups of t equal non-zero |d|
  double w_plus = 0;
  double w_minus = 0;
  double mean = 0;      // of W+ under the null hypothesis, given the ranks: sum r / 2
  double variance = 0;  // sum r^2 / 4

  // Missing where there are more non-zero differences than asked for, or sign_flips_limit.
  std::optional<Tails> exact;

  // Normal approximation; missing where all differences are zero.
  std::optional<double> z;                // (W+ - mean) / sd
  std::optional<double> z_corrected;      // |W+ - mean| smaller by 1/2, not below 0
  std::optional<Tails> normal;            // without continuity correction, as [O] printed
  std::optional<Tails> normal_corrected;  // with

  // Matched-pairs rank-biserial correlation (W+ - W-)/(W+ + W-), Kerby 2014.
  std::optional<double> rank_biserial;
};

// d: finite differences; equal magnitudes are ties to the last bit, so make
// them with paired_differences.
// Above `exact_up_to` non-zero differences there is no exact p.
SignedRankTest wilcoxon(const std::vector<double>& d, Zeros zeros = Zeros::drop,
                        std::size_t exact_up_to = sign_flips_limit);

}  // namespace promenade::analysis
