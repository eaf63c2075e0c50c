// What the analysed people's ratings of motions on pairs of adjectives say ([O] 3): the pairs that
// are kept, their clusters, and how far the raters agree.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/log.h"
#include "analysis/rating_quality.h"
#include "analysis/ratings/rating_statistics.h"
#include "analysis/ratings/stimulus_ratings.h"
#include "analysis/selection.h"
#include "study/adjective_model.h"

namespace promenade::analysis {

struct RatedPairs {
  study::AdjectiveModel model;  // of all motions of the set, also those that nobody rated
  RatingStatistics statistics;
  std::vector<int> people;              // R: of each rater, index into Dataset::people
  int simulated = 0;                    // of the raters
  std::string problem;                  // why there is none of this; empty: there is
  std::vector<StimulusRating> stimuli;  // beside all of this, also where there is a problem
};

// Of the pages of rate tasks that `rated` found, from all files of the log: opens each again,
// read-only. Nothing where no page asks a pair of adjectives. Never throws InputError for what
// somebody answered: then there is a problem.
std::optional<RatedPairs> rated_pairs(const Log& log, const Selection& selection,
                                      const RatingQuality& rated);

}  // namespace promenade::analysis
