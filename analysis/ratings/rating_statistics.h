// How far people agree about motions on pairs of adjectives: over all, pair by pair, and rater
// by rater, so that one who answers at random shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/icc.h"
#include "analysis/statistics/krippendorff_alpha.h"
#include "study/ratings.h"

namespace promenade::analysis {

struct PairStatistics {
  std::vector<int> ratings;  // N: how many raters judged each motion
  KrippendorffAlpha alpha;   // units are the motions
  std::optional<Icc> icc;    // targets are the motions; nothing where `no_icc` says why
  std::string no_icc;
};

struct RaterStatistics {
  int ratings = 0;  // pairs and motions
  // Pearson's, with the mean of the others, over all pairs and motions that both have.
  std::optional<double> correlation;
  double mean = 0, deviation = 0;  // of the rater's values; n - 1
};

// Several ratings of one person, pair and motion count as one, their mean, as the model has it.
struct RatingStatistics {
  KrippendorffAlpha alpha;              // over all; units are a pair of a motion
  std::vector<PairStatistics> pairs;    // P
  std::vector<int> motions;             // N: ratings of each motion, over all pairs
  std::vector<RaterStatistics> raters;  // R
};

RatingStatistics rating_statistics(const study::RatingsTable& table);

}  // namespace promenade::analysis
