#include "analysis/statistics/wilcoxon.h"

#include <algorithm>

#include "analysis/families/family.h"
#include "analysis/statistics/differences.h"
#include "analysis/statistics/hodges_lehmann.h"

namespace promenade::analysis::families {
namespace {

void put_tails(Json& result, const std::string& prefix, const std::optional<Tails>& tails) {
  result[prefix + "_two"] = tails ? Json(tails->two) : Json();
  result[prefix + "_greater"] = tails ? Json(tails->greater) : Json();
  result[prefix + "_less"] = tails ? Json(tails->less) : Json();
}

Json statistics(const SignedRankTest& test) {
  Json result = {{"W_plus", test.w_plus},
                 {"W_minus", test.w_minus},
                 {"T", std::min(test.w_plus, test.w_minus)},
                 {"mean", test.mean},
                 {"var", test.variance},
                 {"z", to_json(test.z)},
                 {"z_cc", to_json(test.z_corrected)},
                 {"rank_biserial", to_json(test.rank_biserial)}};
  put_tails(result, "p_exact", test.exact);
  put_tails(result, "p_asym", test.normal);
  put_tails(result, "p_asym_cc", test.normal_corrected);
  return result;
}

Json location(const std::vector<double>& d) {
  const WalshAverages walsh(d);
  const auto ci = hodges_lehmann_interval(walsh, static_cast<int>(d.size()), 0.95);
  return {{"estimate", to_json(analysis::hodges_lehmann(walsh))},
          {"ci95", ci ? to_json(ci->interval) : Json()},
          {"ci95_level", ci ? Json(ci->level) : Json()}};
}

Differences given_differences(const Json& input) {
  if (!input.contains("d")) {
    const auto x = numbers_or_null(input, "x");
    const auto y = numbers_or_null(input, "y");
    if (x.size() != y.size()) throw CaseError("input.x and input.y differ in length");
    return paired_differences(x, y);
  }
  Differences result;
  for (const auto& value : numbers_or_null(input, "d")) {
    if (value) result.values.push_back(*value);
    result.missing += value ? 0 : 1;
  }
  return result;
}

}  // namespace

Json wilcoxon(const Json& input) {
  const Differences given = given_differences(input);
  std::vector<double> nonzero = given.values;
  nonzero.erase(std::remove(nonzero.begin(), nonzero.end(), 0.0), nonzero.end());
  const SignedRankTest drop = analysis::wilcoxon(given.values, Zeros::drop);
  const SignedRankTest pratt = analysis::wilcoxon(given.values, Zeros::pratt);
  Json result = {{"n", drop.n},
                 {"n_missing", given.missing},
                 {"n_zero", drop.n_zero},
                 {"n_nonzero", drop.n - drop.n_zero},
                 {"n_pos", drop.n_positive},
                 {"n_neg", drop.n_negative},
                 {"tie_sum_nonzero", drop.tie_sum},
                 {"drop", statistics(drop)},
                 {"pratt", statistics(pratt)},
                 {"hl_all", location(given.values)},
                 {"hl_nonzero", location(nonzero)}};
  if (!input.contains("d")) result["d"] = given.values;
  return result;
}

}  // namespace promenade::analysis::families
