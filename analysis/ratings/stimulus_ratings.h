// What people said of stimuli on pairs of adjectives. A stimulus is no mixture of the walks of a
// set, so that no model is made of it: it is described by itself.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/ratings.h"

namespace promenade::analysis {

struct StimulusRating {
  std::string stimulus, pair;
  int raters = 0;
  double mean = 0;                  // over the raters, -2 (first word) to 2
  std::optional<double> deviation;  // n - 1; nothing of one rater
};

// By stimulus, and by pair in the order of the source. Several ratings of one person count as one,
// their mean.
std::vector<StimulusRating> stimulus_ratings(const std::vector<study::NamedRating>& ratings);

}  // namespace promenade::analysis
