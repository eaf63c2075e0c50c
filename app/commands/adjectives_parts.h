// Parts of the documents of `model adjectives` and `model features`, one function each.
#pragma once

#include <string>
#include <vector>

#include "analysis/ratings/rating_statistics.h"
#include "app/print.h"
#include "motion/models/cluster_names.h"
#include "motion/models/ward.h"
#include "study/adjective_model.h"

namespace promenade::app {

Json number_json(double value);  // null: NaN
Json row_json(const Eigen::MatrixXd& values, Eigen::Index row);
Json merges_json(const motion::Dendrogram& tree);

// Agreement of one pair: alphas, intraclass correlations with 95 % intervals, or why not.
Json pair_agreement_json(const analysis::PairStatistics& pair);
std::string pair_agreement_header();
std::string pair_agreement_cells(const analysis::PairStatistics& pair);

// Whether the ratings make sliders, and agreement over all pairs.
Json agreement_json(const study::AdjectiveModel& model,
                    const analysis::RatingStatistics& statistics);
Json raters_json(const study::RatingsTable& table, const analysis::RatingStatistics& statistics);

// How alike clusters and printed ones are, over the items that both have.
Json comparison_json(const std::vector<int>& cluster, const motion::PrintedClusters& printed,
                     const std::vector<std::string>& items);

}  // namespace promenade::app
