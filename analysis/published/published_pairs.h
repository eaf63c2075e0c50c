// The adjectives of a questionnaire study beside the printed ones: which pairs were kept, and in
// which cluster they came.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/published/printed.h"
#include "analysis/ratings/rated_pairs.h"

namespace promenade::analysis {

struct PublishedPair {
  std::string name;  // "slow-fast"
  bool kept_in_print = false;
  std::string cluster_in_print;   // empty: dropped
  std::optional<double> extreme;  // mu*, the largest mean magnitude
  std::optional<double> sigma;    // mean standard deviation over the motions
  motion::PairFate fate = motion::PairFate::unrated;
  std::string cluster;  // of this run; empty: dropped
};

struct PublishedPairs {
  std::vector<PublishedPair> pairs;  // all 41, in the order of Table 1
  int raters = 0, kept = 0, clusters = 0;
  int kept_in_both = 0, dropped_in_both = 0;
  // How alike the two clusterings are, over the pairs that both kept (Hubert and Arabie 1985).
  std::optional<double> adjusted_rand;
  std::string problem;  // why there are no values; empty: there are
};

// `rated`: of the analysed people; nothing: none of them rated pairs.
PublishedPairs published_pairs(const std::optional<RatedPairs>& rated,
                               motion::AdjectivePair::Cluster motion::AdjectivePair::*printed);

}  // namespace promenade::analysis
