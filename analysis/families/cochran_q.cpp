#include "analysis/statistics/cochran_q.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {

Json cochran_q(const Json& input) {
  std::vector<std::vector<bool>> yes;
  for (const std::vector<double>& row : matrix(input, "X")) {
    yes.emplace_back();
    for (const double value : row) {
      if (value != 0 && value != 1) throw CaseError("input.X is not all 0 or 1");
      yes.back().push_back(value == 1);
    }
  }
  const CochranTest test = analysis::cochran_q(yes);
  return {{"n", test.n},
          {"k", test.k},
          {"Q", to_json(test.q)},
          {"df", test.k - 1},
          {"p", to_json(test.p)},
          {"p_exact", to_json(test.p_exact)},
          {"column_totals", test.column_totals}};
}

}  // namespace promenade::analysis::families
