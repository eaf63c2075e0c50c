// The tables of the section on ratings: clusters, pairs of adjectives, raters, and stimuli. There
// must be ratings without a problem, but for stimuli.
#pragma once

#include "analysis/report/html.h"
#include "analysis/report/tables.h"
#include "analysis/results.h"

namespace promenade::analysis {

// ratings_pairs.csv, by the order of the source, ratings_raters.csv, by participant, and
// ratings_stimuli.csv, by stimulus and pair.
Table rated_pair_table(const RatedPairs& rated);
Table pair_rater_table(const Results& results);
Table stimulus_rating_table(const RatedPairs& rated);

// For the page.
HtmlTable shown_clusters(const study::AdjectiveModel& model);
HtmlTable shown_pairs(const RatedPairs& rated);
HtmlTable shown_raters(const Results& results);
HtmlTable shown_stimuli(const RatedPairs& rated);

}  // namespace promenade::analysis
