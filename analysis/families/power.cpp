#include <algorithm>

#include "analysis/families/family.h"
#include "analysis/statistics/power_paired_t.h"
#include "analysis/statistics/power_sign_flips.h"
#include "analysis/statistics/power_simulated.h"
#include "analysis/statistics/sign_flips.h"

namespace promenade::analysis::families {
namespace {

int ranks_in(const Json& input) {
  const int n = whole_number(input, "n");
  if (n > static_cast<int>(sign_flips_limit)) {
    throw CaseError("input.n is larger than " + std::to_string(sign_flips_limit));
  }
  return n;
}

Json to_json(std::optional<std::int64_t> critical) { return critical ? Json(*critical) : Json(); }

Noise noise_in(const Json& input) {
  const std::string name = text(input, "dist");
  if (name == "normal") return Noise::normal;
  if (name == "t3") return Noise::t3;
  if (name == "laplace") return Noise::laplace;
  throw CaseError("input.dist is none of normal, t3 and laplace");
}

// As many studies as draw twenty million differences, a second or two.
int studies_of(int n) { return std::min(100'000, 20'000'000 / std::max(n, 1)); }

}  // namespace

Json power_signflip_exact(const Json& input) {
  const int n = ranks_in(input);
  const double alpha = level(input, "alpha");
  const double p_plus = number(input, "p_plus");
  if (!(p_plus >= 0 && p_plus <= 1)) throw CaseError("input.p_plus is not from 0 to 1");
  const auto exact = critical_rank_sum(n, alpha);
  const auto normal = critical_rank_sum_normal(n, alpha);
  return {{"power_exact", sign_flip_power(n, p_plus, exact)},
          {"crit_T_exact", to_json(exact)},
          {"power_asym", sign_flip_power(n, p_plus, normal)},
          {"crit_T_asym", to_json(normal)}};
}

Json power_simulated(const Json& input) {
  SimulatedStudies studies;
  studies.n = ranks_in(input);
  studies.shift = number(input, "shift");
  studies.noise = noise_in(input);
  studies.alpha = level(input, "alpha");
  studies.count = studies_of(studies.n);
  if (input.contains("test") && text(input, "test") != "wilcoxon exact two-sided") {
    throw CaseError("input.test is not \"wilcoxon exact two-sided\"");
  }
  const SimulatedPower result = simulated_power(studies);
  return {{"power", families::to_json(result.power)},
          {"mc_se", families::to_json(result.se)},
          {"crit_T", to_json(result.critical)},
          {"n_experiments", studies.count}};
}

Json power_paired_t(const Json& input) {
  const double sd = number(input, "sd");
  if (!(sd > 0)) throw CaseError("input.sd is not above 0");
  const auto power = analysis::power_paired_t(whole_number(input, "n"), number(input, "delta"), sd,
                                              level(input, "alpha"));
  return {{"power", families::to_json(power)}};
}

}  // namespace promenade::analysis::families
