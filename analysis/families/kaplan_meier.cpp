#include "analysis/statistics/kaplan_meier.h"

#include "analysis/families/family.h"

namespace promenade::analysis::families {
namespace {

Json ends(const std::optional<Interval>& interval) {
  return interval ? to_json(*interval) : Json::array({nullptr, nullptr});
}

void put_step(Json& result, const SurvivalStep& step) {
  result["time"].push_back(step.time);
  result["n_risk"].push_back(step.at_risk);
  result["n_event"].push_back(step.done);
  result["n_censor"].push_back(step.censored);
  result["surv"].push_back(step.survival);
  result["greenwood_se"].push_back(to_json(step.se));
  result["ci95_log"].push_back(ends(step.log));
  result["ci95_loglog"].push_back(ends(step.loglog));
}

}  // namespace

Json kaplan_meier(const Json& input) {
  const double tau = number(input, "tau");
  if (tau < 0) throw CaseError("input.tau is negative");
  const Survival survival = analysis::kaplan_meier(durations_of(input));
  const RestrictedMean mean = restricted_mean(survival, tau);
  Json result = {{"median", to_json(survival.median)},
                 {"median_R_midpoint", to_json(survival.median_midpoint)},
                 {"rmst_tau", mean.mean},
                 {"rmst_se", mean.se},
                 {"rmst_ci95", to_json(mean.interval)}};
  for (const char* key : {"time", "n_risk", "n_event", "n_censor", "surv", "greenwood_se",
                          "ci95_log", "ci95_loglog"}) {
    result[key] = Json::array();
  }
  for (const SurvivalStep& step : survival.steps) put_step(result, step);
  return result;
}

}  // namespace promenade::analysis::families
