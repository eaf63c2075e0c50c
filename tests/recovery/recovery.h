// Does `model adjectives` find the clusters that are there, and none where there are none?
// Ratings are made from a matrix of factor loadings, so that the truth is known.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/ratings.h"

namespace promenade::recovery {

// Which factor each pair of adjectives follows; `nothing`: none, it is guesswork.
struct Truth {
  static constexpr int factors = 4;
  static constexpr int nothing = factors;
  std::vector<int> factor;   // P
  Eigen::MatrixXd loadings;  // P x 4: 0.7 to 1 of its own factor, and some of the others
};

// 41 pairs: 29 that follow a factor, as many as [O] kept of its set B, in clusters of 4, 6, 8 and
// 11, and 12 that follow none. `cross`: standard deviation of the other loadings.
Truth make_truth(double cross, std::uint64_t seed);

// Motions have a place on each factor, standard normal; a rater sees it through the loadings,
// adds a leaning of 0.2 and doubt of 0.5 (1.2 where there is nothing to see), and rounds to the
// five-point scale.
study::RatingsTable rate(const Truth& truth, int raters, int motions, std::uint64_t seed);

// Raters who answer anything from -2 to 2.
study::RatingsTable rate_blindly(int raters, int motions, std::uint64_t seed);

struct Recovery {
  int seeds = 0;
  std::vector<double> rand_index;  // of each seed: the clusters found and the known ones
  std::vector<double> kept;        // pairs
  int refused = 0;                 // the ratings did not agree
};

Recovery recover(int raters, int motions, double cross, int seeds);
int refused_blind_raters(int raters, int motions, int seeds);
int refused_raters_of(const std::string& builtin_set, int seeds);

}  // namespace promenade::recovery
