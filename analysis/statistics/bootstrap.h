// The bootstrap (Efron & Tibshirani 1993): how a mean or a median varies over samples drawn
// from the sample, with repetition. A seed makes the same draws on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/statistics/interval.h"

namespace promenade::analysis {

enum class Location { mean, median };

std::optional<double> location_of(Location kind, const std::vector<double>& x);

// The location of `count` samples of x.size() values drawn from x. x is finite; nothing for no
// values. The same x in another order is another sequence of draws of the same kind.
std::vector<double> bootstrap_replicates(Location kind, const std::vector<double>& x, int count,
                                         std::uint64_t seed);

// Nothing where it is not defined: no values, no replicates, all replicates on one side of the
// estimate (bias, bca), values that do not differ (acceleration, bca).
struct BootstrapIntervals {
  std::optional<double> estimate;      // t, of the sample
  std::optional<Interval> percentile;  // quantiles q of the replicates (type 7, linear)
  std::optional<Interval> basic;       // 2 t - q
  // Phi^-1 of the part of the replicates below t, equal ones (to 1e-9 of the largest) by half.
  std::optional<double> bias;
  // Of the jackknife: sum L^3 / (6 (sum L^2)^1.5), L_i = mean - t without i.
  std::optional<double> acceleration;
  // Bias-corrected and accelerated (Efron 1987): quantiles at Phi(b + (b + z)/(1 - a (b + z))).
  std::optional<Interval> bca;
};

// 0 < level < 1; x and replicates are finite.
BootstrapIntervals bootstrap_intervals(Location kind, const std::vector<double>& x,
                                       std::vector<double> replicates, double level);

// What medians of infinitely many replicates do, exactly: the k-th smallest of n values (n odd)
// is not exceeded with probability F(k) = P(Bin(n, k/n) >= (n + 1)/2).
struct IdealMedian {
  int lower = 0, upper = 0;             // places from 1: the first F >= (1 -+ level)/2
  Interval interval;                    // the values there
  Interval around_lower, around_upper;  // F just before those places and there
  double margin = 0;                    // how close these come to (1 -+ level)/2
  std::optional<double> mean, se;       // of the medians
};

// x: an odd number of finite values. 0 < level < 1.
IdealMedian ideal_bootstrap_median(std::vector<double> x, double level);

}  // namespace promenade::analysis
