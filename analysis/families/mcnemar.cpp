#include "analysis/statistics/mcnemar.h"

#include <cmath>

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

// People with the second outcome only, and with the first only.
struct Changes {
  int b = 0, c = 0;
};

int count(double value) {
  if (!(value >= 0 && value <= 1e9) || value != std::floor(value)) {
    throw CaseError("input.table holds what is no count");
  }
  return static_cast<int>(value);
}

Changes in_table(const Json& input) {
  const auto table = matrix(input, "table");
  if (table.size() != 2 || table[0].size() != 2) throw CaseError("input.table is not 2 by 2");
  return {count(table[0][1]), count(table[1][0])};
}

Changes in_pairs(const Json& input) {
  const std::vector<double> x = numbers(input, "x");
  const std::vector<double> y = numbers(input, "y");
  if (x.size() != y.size()) throw CaseError("input.x and input.y differ in length");
  Changes changes;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const bool binary = (x[i] == 0 || x[i] == 1) && (y[i] == 0 || y[i] == 1);
    if (!binary) throw CaseError("input.x and input.y are not all 0 or 1");
    changes.b += x[i] < y[i] ? 1 : 0;
    changes.c += x[i] > y[i] ? 1 : 0;
  }
  return changes;
}

}  // namespace

Json mcnemar(const Json& input) {
  const auto [b, c] = input.contains("table") ? in_table(input) : in_pairs(input);
  const McNemarTest test = analysis::mcnemar(b, c);
  return {{"b", b},
          {"c", c},
          {"p_exact", test.p_exact},
          {"p_mid", test.p_mid},
          {"chi2", to_json(test.chi2)},
          {"p_chi2", to_json(test.p_chi2)},
          {"chi2_cc", to_json(test.chi2_corrected)},
          {"p_chi2_cc", to_json(test.p_chi2_corrected)}};
}

}  // namespace promenade::analysis::families
