#include "analysis/statistics/friedman.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

void put_pairs(Json& result, const std::vector<RankPair>& pairs) {
  for (const char* key : {"posthoc_pairs", "posthoc_z", "posthoc_p_normal", "posthoc_p_normal_holm",
                          "posthoc_p_nemenyi"}) {
    result[key] = Json::array();
  }
  for (const RankPair& pair : pairs) {
    result["posthoc_pairs"].push_back(Json::array({pair.a, pair.b}));
    result["posthoc_z"].push_back(pair.z);
    result["posthoc_p_normal"].push_back(pair.p_normal);
    result["posthoc_p_normal_holm"].push_back(pair.p_holm);
    result["posthoc_p_nemenyi"].push_back(pair.p_nemenyi);
  }
}

}  // namespace

Json friedman(const Json& input) {
  const auto x = matrix(input, "X");
  if (x[0].size() < 2) throw CaseError("input.X has one column; a test needs two");
  const FriedmanTest test = analysis::friedman(x);
  Json result = {{"n", test.n},
                 {"k", test.k},
                 {"chi2", to_json(test.chi2)},
                 {"df", test.k - 1},
                 {"p", to_json(test.p)},
                 {"kendall_W", to_json(test.kendall_w)},
                 {"iman_davenport_F", to_json(test.f)},
                 {"iman_davenport_df", Json::array({test.k - 1, (test.k - 1) * (test.n - 1)})},
                 {"iman_davenport_p", to_json(test.p_f)},
                 {"mean_ranks", test.mean_ranks},
                 {"p_exact", to_json(test.p_exact)}};
  put_pairs(result, test.pairs);
  return result;
}

}  // namespace promenade::analysis::families
