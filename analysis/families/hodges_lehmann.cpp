#include "analysis/statistics/hodges_lehmann.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

Json one_sample(const std::vector<double>& x) {
  const WalshAverages walsh(x);
  Json result = {{"type", "one_sample"}, {"estimate", to_json(analysis::hodges_lehmann(walsh))}};
  for (const auto& [name, asked] : {std::pair{"ci90", 0.90}, {"ci95", 0.95}, {"ci99", 0.99}}) {
    const auto ci = hodges_lehmann_interval(walsh, static_cast<int>(x.size()), asked);
    result[name] = ci ? to_json(ci->interval) : Json();
    result[std::string(name) + "_level"] = ci ? Json(ci->level) : Json();
  }
  return result;
}

Json two_sample(const std::vector<double>& x, const std::vector<double>& y) {
  return {{"type", "two_sample_shift"},
          {"estimate", to_json(shift_estimate(x, y))},
          {"ci95_R_exact", to_json(shift_interval(x, y, 0.95))}};
}

}  // namespace

Json hodges_lehmann(const Json& input) {
  if (input.contains("y")) return two_sample(numbers(input, "x"), numbers(input, "y"));
  return one_sample(numbers(input, "x"));
}

}  // namespace promenade::analysis::families
