// The tables of the section on ratings: clusters, pairs of adjectives, and raters. There must be
// ratings without a problem.
#pragma once

#include "analysis/report/html.h"
#include "analysis/report/tables.h"
#include "analysis/results.h"

namespace promenade::analysis {

// ratings_pairs.csv, by the order of the source, and ratings_raters.csv, by participant.
Table rated_pair_table(const RatedPairs& rated);
Table pair_rater_table(const Results& results);

// For the page.
HtmlTable shown_clusters(const study::AdjectiveModel& model);
HtmlTable shown_pairs(const RatedPairs& rated);
HtmlTable shown_raters(const Results& results);

}  // namespace promenade::analysis
