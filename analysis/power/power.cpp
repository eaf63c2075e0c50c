#include "analysis/power/power.h"

#include <algorithm>
#include <cmath>

#include "analysis/item.h"
#include "analysis/statistics/median.h"
#include "analysis/statistics/power_paired_t.h"
#include "analysis/statistics/power_sign_flips.h"
#include "analysis/statistics/proportion.h"
#include "analysis/statistics/sign_flips.h"

namespace promenade::analysis {
namespace {

struct Moments {
  double mean = 0, sd = 0;
};

Moments moments_of(const std::vector<double>& values) {
  Moments moments;
  for (const double value : values) moments.mean += value;
  moments.mean /= static_cast<double>(values.size());
  for (const double value : values) moments.sd += std::pow(value - moments.mean, 2);
  moments.sd = std::sqrt(moments.sd / static_cast<double>(values.size() - 1));
  return moments;
}

// Of those that are not zero; the test drops those.
double share_positive(const std::vector<double>& values) {
  const auto positive =
      std::count_if(values.begin(), values.end(), [](double value) { return value > 0; });
  const auto other =
      std::count_if(values.begin(), values.end(), [](double value) { return value != 0; });
  return other == 0 ? 0.5 : static_cast<double>(positive) / static_cast<double>(other);
}

}  // namespace

double Rate::share() const { return studies == 0 ? 0 : static_cast<double>(found) / studies; }

double Rate::standard_error() const {
  return studies == 0 ? 0 : std::sqrt(share() * (1 - share()) / studies);
}

Interval Rate::interval() const { return wilson_interval(found, studies); }

PowerRow power_row(const std::vector<PairFinding>& findings, double alpha) {
  PowerRow row;
  std::vector<double> estimates;
  for (const PairFinding& finding : findings) {
    row.holm.found += finding.p_holm && *finding.p_holm <= alpha ? 1 : 0;
    row.alone.found += finding.p && *finding.p <= alpha ? 1 : 0;
    if (finding.hl) estimates.push_back(*finding.hl);
  }
  row.holm.studies = row.alone.studies = size_of(findings);
  std::sort(estimates.begin(), estimates.end());
  row.hl = median_of_sorted(estimates);
  return row;
}

void add_formulas(PowerRow& row, const std::vector<double>& differences, double alpha) {
  if (differences.size() < 2) return;
  const auto [mean, sd] = moments_of(differences);
  const bool varies = sd > 1e-12 * std::abs(mean);
  if (varies) row.paired_t = power_paired_t(row.participants, mean, sd, alpha);
  if (static_cast<std::size_t>(row.participants) > sign_flips_limit) return;
  row.sign_flips = sign_flip_power(row.participants, share_positive(differences),
                                   critical_rank_sum(row.participants, alpha));
}

std::optional<int> enough(const std::vector<PowerRow>& rows, const std::string& a,
                          const std::string& b, double wanted) {
  std::optional<int> fewest;
  for (const PowerRow& row : rows) {
    if (row.a != a || row.b != b || row.holm.share() < wanted) continue;
    fewest = std::min(fewest.value_or(row.participants), row.participants);
  }
  return fewest;
}

}  // namespace promenade::analysis
