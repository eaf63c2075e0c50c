#include "app/commands/adjectives_parts.h"

#include <cmath>

#include "motion/models/rand_index.h"
#include "study/csv.h"

namespace promenade::app {
namespace {

using analysis::PairStatistics;

Json interval_json(const std::optional<analysis::Interval>& interval) {
  return interval ? Json({interval->lower, interval->upper}) : Json();
}

Json icc_json(const PairStatistics& pair) {
  if (!pair.icc) return nullptr;
  return {{"agreement", to_json(pair.icc->agreement)},
          {"interval", interval_json(pair.icc->interval)},
          {"agreement_mean", to_json(pair.icc->agreement_mean)},
          {"interval_mean", interval_json(pair.icc->interval_mean)},
          {"raters", pair.icc->k}};
}

std::string cell(const std::optional<double>& value) {
  return value ? study::csv_number(*value) : std::string();
}

int total(const std::vector<int>& counts) {
  int sum = 0;
  for (const int count : counts) sum += count;
  return sum;
}

Json names_of(const std::vector<int>& places, const std::vector<std::string>& items) {
  Json names = Json::array();
  for (const int i : places) names.push_back(items[static_cast<std::size_t>(i)]);
  return names;
}

}  // namespace

Json number_json(double value) { return std::isnan(value) ? Json() : Json(value); }

Json row_json(const Eigen::MatrixXd& values, Eigen::Index row) {
  Json list = Json::array();
  for (const double value : values.row(row)) list.push_back(number_json(value));
  return list;
}

Json merges_json(const motion::Dendrogram& tree) {
  Json merges = Json::array();
  for (const motion::Merge& merge : tree.merges) {
    merges.push_back(
        {{"a", merge.a}, {"b", merge.b}, {"height", merge.height}, {"cost", merge.cost()}});
  }
  return merges;
}

Json pair_agreement_json(const PairStatistics& pair) {
  return {{"ratings", pair.ratings},
          {"alpha",
           {{"ordinal", to_json(pair.alpha.ordinal)}, {"interval", to_json(pair.alpha.interval)}}},
          {"icc", icc_json(pair)},
          {"no_icc", pair.no_icc.empty() ? Json() : Json(pair.no_icc)}};
}

std::string pair_agreement_header() {
  return "ratings,alpha_ordinal,alpha_interval,icc_agreement,icc_agreement_mean";
}

std::string pair_agreement_cells(const PairStatistics& pair) {
  const auto icc = pair.icc.value_or(analysis::Icc{});
  return std::to_string(total(pair.ratings)) + "," + cell(pair.alpha.ordinal) + "," +
         cell(pair.alpha.interval) + "," + cell(icc.agreement) + "," + cell(icc.agreement_mean);
}

Json agreement_json(const study::AdjectiveModel& model,
                    const analysis::RatingStatistics& statistics) {
  const study::RaterAgreement& found = model.agreement;
  return {{"sentence", describe(found)},
          {"pairs_asked", found.asked},
          {"pairs_kept", found.kept},
          {"pairs_needed", found.wanted},
          {"explained", found.explained},
          {"p", found.p},
          {"level", study::RaterAgreement::level},
          {"shuffles", study::RaterAgreement::shuffles},
          {"alpha",
           {{"ordinal", to_json(statistics.alpha.ordinal)},
            {"interval", to_json(statistics.alpha.interval)}}}};
}

Json raters_json(const study::RatingsTable& table, const analysis::RatingStatistics& statistics) {
  Json raters = Json::array();
  for (std::size_t r = 0; r < statistics.raters.size(); ++r) {
    const analysis::RaterStatistics& one = statistics.raters[r];
    raters.push_back({{"rater", table.rater_names[r]},
                      {"ratings", one.ratings},
                      {"correlation", to_json(one.correlation)},
                      {"mean", one.mean},
                      {"deviation", one.deviation}});
  }
  return raters;
}

Json comparison_json(const std::vector<int>& cluster, const motion::PrintedClusters& printed,
                     const std::vector<std::string>& items) {
  const motion::PrintedComparison found = motion::compare_with_printed(cluster, printed);
  Json rows = Json::array();
  for (const int i : found.items) {
    const auto at = static_cast<std::size_t>(i);
    rows.push_back({{"name", items[at]}, {"cluster", cluster[at]}, {"printed", printed[at]}});
  }
  return {{"rand_index", found.items.size() < 2 ? Json() : Json(found.rand_index)},
          {"count", found.items.size()},
          {"pairs", rows},
          {"not_printed", names_of(found.missing, items)}};
}

}  // namespace promenade::app
