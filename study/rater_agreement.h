// Do people mean the same when they rate motions? Sliders are only made of ratings that
// agree (docs/methods.md, 8; ours): [O] has two thresholds for pairs of adjectives, and says
// nothing about ratings of which too few pairs are left, or that would pass by chance.
#pragma once

#include <string>

#include "study/ratings.h"

namespace promenade::study {

// The ratings agree when `kept` is at least `wanted` and `p` at most `level`.
//
// p is of a permutation test: each rater's motions are shuffled, for all pairs alike, and the
// thresholds applied anew. How much of the variance within raters do the motions explain, summed
// over the pairs that are left? Where no rater rated two motions, all ratings are shuffled.
struct RaterAgreement {
  static constexpr int shuffles = 199;
  static constexpr double level = 0.01;

  int asked = 0;                                      // pairs
  int kept = 0;                                       // left by the two thresholds
  int never_extreme = 0, disagreed = 0, unrated = 0;  // dropped, by the first reason
  int wanted = 0;        // one pair for each slider, or all if fewer were asked
  double explained = 0;  // mean of the shares of variance, over the kept pairs, 0 to 1
  double p = 1;          // 1/200 to 1; 1 where no pair is left

  bool enough() const { return kept >= wanted && kept > 0; }
  bool agrees() const { return enough() && p <= level; }
};

// `quantification` is of the same table with the same options.
RaterAgreement rater_agreement(const RatingsTable& table,
                               const motion::Quantification& quantification,
                               const motion::QuantificationOptions& options);

// "the ratings agree: ..." or "the ratings do not agree: 1 of 41 pairs is left, ...": with
// numbers, and what to do.
std::string describe(const RaterAgreement& agreement);

}  // namespace promenade::study
