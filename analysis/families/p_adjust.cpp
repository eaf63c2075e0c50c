#include "analysis/statistics/p_adjust.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {

Json p_adjust(const Json& input) {
  const std::vector<double> p = numbers(input, "p");
  for (const double value : p) {
    if (!(value >= 0 && value <= 1)) throw CaseError("input.p holds a value outside 0 to 1");
  }
  return {{"holm", adjust_holm(p)},
          {"bh", adjust_bh(p)},
          {"bonferroni", adjust_bonferroni(p)},
          {"hochberg", adjust_hochberg(p)},
          {"by", adjust_by(p)}};
}

}  // namespace promenade::analysis::families
