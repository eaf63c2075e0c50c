#include "analysis/statistics/bootstrap.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

Location location_in(const Json& input) {
  const std::string name = text(input, "statistic");
  if (name == "mean") return Location::mean;
  if (name == "median") return Location::median;
  throw CaseError("input.statistic is neither mean nor median");
}

}  // namespace

Json bootstrap_median_ideal(const Json& input) {
  const std::vector<double> x = numbers(input, "x");
  if (x.size() % 2 == 0) throw CaseError("input.x has no odd number of values");
  const IdealMedian ideal = ideal_bootstrap_median(x, level(input, "conf"));
  return {{"percentile_ci", to_json(ideal.interval)},
          {"order_stats", Json::array({ideal.lower, ideal.upper})},
          {"cdf_at_lo", to_json(ideal.around_lower)},
          {"cdf_at_hi", to_json(ideal.around_upper)},
          {"ideal_se", to_json(ideal.se)},
          {"ideal_mean", to_json(ideal.mean)},
          {"min_margin", ideal.margin}};
}

Json bootstrap_ci_given_replicates(const Json& input) {
  const Location location = location_in(input);
  const BootstrapIntervals result = bootstrap_intervals(
      location, numbers(input, "x"), numbers(input, "replicates"), level(input, "conf"));
  return {{"estimate", to_json(result.estimate)},
          {"percentile", to_json(result.percentile)},
          {"basic", to_json(result.basic)},
          {"z0", to_json(result.bias)},
          {"acceleration", to_json(result.acceleration)},
          {"bca", to_json(result.bca)}};
}

}  // namespace promenade::analysis::families
