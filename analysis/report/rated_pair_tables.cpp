#include "analysis/report/rated_pair_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/format.h"
#include "analysis/item.h"
#include "analysis/report/cells.h"

namespace promenade::analysis {
namespace {

using motion::PairFate;
using study::AdjectiveModel;

std::string fate_words(PairFate fate) {
  switch (fate) {
    case PairFate::kept:
      return "kept";
    case PairFate::never_extreme:
      return "never extreme";
    case PairFate::disagreed:
      return "disagreed";
    case PairFate::unrated:
      return "not rated everywhere";
  }
  return "";
}

// Empty: the pair is dropped.
std::string cluster_of(const AdjectiveModel& model, int pair) {
  const motion::Quantification& q = model.quantification;
  const auto found = std::find(q.kept.begin(), q.kept.end(), pair);
  if (found == q.kept.end()) return "";
  return item(model.names, item(q.cluster, static_cast<int>(found - q.kept.begin())));
}

// Raters in the order of the people.
std::vector<int> by_person(const RatedPairs& rated) {
  std::vector<int> order(rated.people.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return item(rated.people, a) < item(rated.people, b); });
  return order;
}

std::string icc_cell(const PairStatistics& pair) {
  if (!pair.icc || !pair.icc->agreement_mean) return dash;
  const std::string mean = fixed(*pair.icc->agreement_mean, 2);
  const auto& interval = pair.icc->interval_mean;
  if (!interval) return mean;
  return mean + " [" + fixed(interval->lower, 2) + ", " + fixed(interval->upper, 2) + "]";
}

}  // namespace

Table rated_pair_table(const RatedPairs& rated) {
  const AdjectiveModel& model = rated.model;
  Table table{
      "ratings_pairs",
      "A pair of adjectives that was asked: what the thresholds made of it, its cluster, and "
      "how far raters agree.",
      {"pair", "extreme", "sigma", "fate", "cluster", "ratings", "alpha_ordinal", "alpha_interval",
       "icc_2k", "icc_2k_ci_lower", "icc_2k_ci_upper", "no_icc"},
      {}};
  for (int pair = 0; pair < size_of(model.table.pairs); ++pair) {
    const PairStatistics& one = item(rated.statistics.pairs, pair);
    const Icc icc = one.icc.value_or(Icc{});
    table.rows.push_back(
        {cell(item(model.table.pairs, pair)), cell(model.quantification.extreme(pair)),
         cell(model.quantification.disagreement(pair)),
         cell(fate_words(item(model.quantification.fate, pair))), cell(cluster_of(model, pair)),
         cell(std::accumulate(one.ratings.begin(), one.ratings.end(), 0)), cell(one.alpha.ordinal),
         cell(one.alpha.interval), cell(icc.agreement_mean), lower(icc.interval_mean),
         upper(icc.interval_mean), cell(one.no_icc)});
  }
  return table;
}

Table pair_rater_table(const Results& results) {
  const RatedPairs& rated = *results.rated_pairs;
  Table table{"ratings_raters",
              "A rater of pairs of adjectives, and Pearson's correlation with the mean of the "
              "others.",
              {"participant", "ratings", "correlation", "mean", "sd"},
              {}};
  for (const int rater : by_person(rated)) {
    const RaterStatistics& one = item(rated.statistics.raters, rater);
    table.rows.push_back({cell(item(results.data.people, item(rated.people, rater))),
                          cell(one.ratings), cell(one.correlation), cell(one.mean),
                          cell(one.deviation)});
  }
  return table;
}

HtmlTable shown_clusters(const AdjectiveModel& model) {
  HtmlTable table;
  table.caption =
      "Clusters of the kept pairs by Ward's method. Each has the name of the printed cluster ([O] "
      "Tables 2 and 3) that it is most like, and how much, from 0 to 1: twice the pairs in both, "
      "by "
      "the pairs of the two. A cluster that is like none has the name of its most typical pair.";
  table.columns = {"cluster (pairs)", "like the printed one", "pairs"};
  for (int c = 0; c < size_of(model.names); ++c) {
    const std::vector<std::string> pairs = pairs_of(model, c);
    const double agreement = item(model.name_agreement, c);
    table.rows.push_back({fmt::format("{} ({})", item(model.names, c), pairs.size()),
                          agreement > 0 ? fixed(agreement, 2) : dash, listed(pairs)});
  }
  return table;
}

HtmlTable shown_pairs(const RatedPairs& rated) {
  const AdjectiveModel& model = rated.model;
  HtmlTable table;
  table.caption =
      "All pairs that were asked. μ* is the largest mean magnitude of any motion, σ the mean "
      "standard deviation over raters; bold: kept. Alpha is Krippendorff's for ordinal ratings. "
      "ICC(2,k) is about the mean of all raters, with its 95 % interval (McGraw and Wong); it "
      "needs "
      "every rater's word on every motion.";
  table.columns = {"pair", "μ*", "σ", "fate", "cluster", "alpha", "ICC(2,k) [95 % CI]"};
  for (int pair = 0; pair < size_of(model.table.pairs); ++pair) {
    const PairStatistics& one = item(rated.statistics.pairs, pair);
    const PairFate fate = item(model.quantification.fate, pair);
    const std::string cluster = cluster_of(model, pair);
    const auto shown = [](double value) {
      return std::isfinite(value) ? fixed(value, 2) : std::string(dash);
    };
    table.rows.push_back({item(model.table.pairs, pair), shown(model.quantification.extreme(pair)),
                          shown(model.quantification.disagreement(pair)), fate_words(fate),
                          cluster.empty() ? dash : cluster, number_cell(one.alpha.ordinal, 2),
                          icc_cell(one)});
    table.strong.push_back(fate == PairFate::kept);
  }
  return table;
}

HtmlTable shown_raters(const Results& results) {
  const RatedPairs& rated = *results.rated_pairs;
  HtmlTable table;
  table.caption =
      "Raters. The correlation is Pearson's with the mean of the others, over all pairs and "
      "motions "
      "that both have: near zero or below is somebody who means other things, or rates at random.";
  table.columns = {"participant", "ratings", "correlation", "mean", "SD"};
  for (const int rater : by_person(rated)) {
    const RaterStatistics& one = item(rated.statistics.raters, rater);
    table.rows.push_back({item(results.data.people, item(rated.people, rater)),
                          std::to_string(one.ratings), number_cell(one.correlation, 2),
                          fixed(one.mean, 2), fixed(one.deviation, 2)});
  }
  return table;
}

Table stimulus_rating_table(const RatedPairs& rated) {
  Table table{
      "ratings_stimuli",
      "A stimulus and a pair of adjectives: what the raters said, -2 (the first word) to 2. "
      "Stimuli are no part of the clusters.",
      {"stimulus", "pair", "raters", "mean", "sd"},
      {}};
  for (const StimulusRating& one : rated.stimuli) {
    table.rows.push_back({cell(one.stimulus), cell(one.pair), cell(one.raters), cell(one.mean),
                          cell(one.deviation)});
  }
  return table;
}

HtmlTable shown_stimuli(const RatedPairs& rated) {
  HtmlTable table;
  table.caption =
      "Stimuli: the mean over raters from −2 (the first word of the pair) to 2 (the second), and "
      "its standard deviation.";
  table.columns = {"stimulus", "pair", "raters", "mean", "SD"};
  table.heads = 2;
  for (const StimulusRating& one : rated.stimuli) {
    table.rows.push_back({one.stimulus, one.pair, std::to_string(one.raters), fixed(one.mean, 2),
                          number_cell(one.deviation, 2)});
  }
  return table;
}

}  // namespace promenade::analysis
