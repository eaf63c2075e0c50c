#include "analysis/statistics/proportion.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

Json proportion(const Json& input, Interval (*interval)(int, int, double)) {
  const int x = whole_number(input, "x");
  const int n = whole_number(input, "n");
  if (x > n) throw CaseError("input.x is larger than input.n");
  const double confidence = level(input, "conf");
  return {{"estimate", n == 0 ? Json() : Json(static_cast<double>(x) / n)},
          {"ci", to_json(interval(x, n, confidence))}};
}

}  // namespace

Json wilson(const Json& input) { return proportion(input, wilson_interval); }

Json clopper_pearson(const Json& input) { return proportion(input, clopper_pearson_interval); }

}  // namespace promenade::analysis::families
