#include "analysis/families/family.h"
#include "analysis/statistics/cronbach_alpha.h"
#include "analysis/statistics/icc.h"
#include "analysis/statistics/krippendorff_alpha.h"

namespace promenade::analysis::families {

Json cronbach_alpha(const Json& input) {
  const CronbachAlpha result = analysis::cronbach_alpha(matrix(input, "X"));
  Json dropped;
  for (const auto& alpha : result.if_dropped) dropped.push_back(to_json(alpha));
  return {{"n", result.n},
          {"k", result.k},
          {"alpha", to_json(result.alpha)},
          {"ci95", to_json(result.interval)},
          {"alpha_standardized", to_json(result.standardized)},
          {"alpha_if_dropped", dropped}};
}

Json icc(const Json& input) {
  const Icc result = analysis::icc(matrix(input, "X"));
  return {{"n", result.n},
          {"k", result.k},
          {"ms_rows", to_json(result.ms_rows)},
          {"ms_cols", to_json(result.ms_cols)},
          {"ms_error", to_json(result.ms_error)},
          {"ms_within", to_json(result.ms_within)},
          {"icc_1_1", to_json(result.one_way)},
          {"icc_2_1", to_json(result.agreement)},
          {"icc_3_1", to_json(result.consistency)},
          {"icc_1_k", to_json(result.one_way_mean)},
          {"icc_2_k", to_json(result.agreement_mean)},
          {"icc_3_k", to_json(result.consistency_mean)},
          {"F_rows", to_json(result.f_rows)},
          {"df", Json::array({result.n - 1, (result.n - 1) * (result.k - 1)})},
          {"p_F_rows", to_json(result.p_rows)},
          {"ci95_2_1", to_json(result.interval)},
          {"ci95_2_k", to_json(result.interval_mean)}};
}

Json krippendorff_alpha(const Json& input) {
  const KrippendorffAlpha result =
      analysis::krippendorff_alpha(matrix_or_null(input, "ratings_rater_by_unit"));
  return {{"nominal", to_json(result.nominal)},
          {"ordinal", to_json(result.ordinal)},
          {"interval", to_json(result.interval)},
          {"ratio", to_json(result.ratio)},
          {"n_pairable", result.pairable}};
}

}  // namespace promenade::analysis::families
