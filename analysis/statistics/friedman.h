// Friedman's test of more than two conditions (Friedman 1937), with Kendall's W, the F of
// Iman & Davenport (1980) and the comparisons of all pairs by mean ranks (Nemenyi 1963).
#pragma once

#include <optional>
#include <vector>

namespace promenade::analysis {

struct RankPair {
  int a = 0, b = 0;     // conditions
  double z = 0;         // of the mean ranks, without correction for ties
  double p_normal = 1;  // two-sided
  double p_holm = 1;    // over all pairs
  double p_nemenyi = 1;
};

struct FriedmanTest {
  int n = 0, k = 0;                // subjects and conditions
  std::vector<double> mean_ranks;  // midranks within each subject
  // Nothing where every subject has the same value under all conditions.
  std::optional<double> chi2, p, kendall_w;  // corrected for ties
  std::optional<double> f, p_f;              // no F, and p = 0, where all agree
  std::optional<double> p_exact;             // see row_permutations.h
  std::vector<RankPair> pairs;               // in the order of the conditions
};

// x[subject][condition]; at least one subject and two conditions, rows of equal length.
FriedmanTest friedman(const std::vector<std::vector<double>>& x);

// P(the range of k independent standard normals > q).
double range_tail(double q, int k);

}  // namespace promenade::analysis
