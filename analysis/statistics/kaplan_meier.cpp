#include "analysis/statistics/kaplan_meier.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace promenade::analysis {
namespace {

// S is a ratio of whole numbers; a product of rounded factors may miss 1/2 by this much.
constexpr double half = 0.5 + 1e-9;

double z_of_95() { return boost::math::quantile(boost::math::normal(), 0.975); }

// Of the variance of log S: d / (n (n - d)).
double greenwood_term(const SurvivalStep& step) {
  return static_cast<double>(step.done) / step.at_risk / (step.at_risk - step.done);
}

void add_intervals(SurvivalStep& step, double greenwood) {
  if (step.survival == 0) return;
  const double width = z_of_95() * std::sqrt(greenwood);
  step.se = step.survival * std::sqrt(greenwood);
  step.log =
      Interval{step.survival * std::exp(-width), std::min(step.survival * std::exp(width), 1.0)};
  if (step.survival == 1) return;
  const double log_s = std::log(step.survival);
  const double factor = std::exp(width / -log_s);
  step.loglog = Interval{std::exp(log_s * factor), std::exp(log_s / factor)};
}

void add_medians(Survival& survival) {
  const auto& steps = survival.steps;
  const auto first = std::find_if(steps.begin(), steps.end(),
                                  [](const SurvivalStep& step) { return step.survival <= half; });
  if (first == steps.end()) return;
  survival.median = survival.median_midpoint = first->time;
  if (first->survival < 1 - half) return;
  const auto next =
      std::find_if(first + 1, steps.end(), [](const SurvivalStep& step) { return step.done > 0; });
  if (next != steps.end()) survival.median_midpoint = first->time / 2 + next->time / 2;
}

}  // namespace

Survival kaplan_meier(std::vector<Duration> durations) {
  std::sort(durations.begin(), durations.end(),
            [](const Duration& a, const Duration& b) { return a.time < b.time; });
  Survival survival;
  double s = 1;
  double greenwood = 0;
  for (std::size_t i = 0; i < durations.size();) {
    SurvivalStep step;
    step.time = durations[i].time;
    step.at_risk = static_cast<int>(durations.size() - i);
    for (; i < durations.size() && durations[i].time == step.time; ++i) {
      ++(durations[i].done ? step.done : step.censored);
    }
    s *= static_cast<double>(step.at_risk - step.done) / step.at_risk;
    step.survival = s;
    if (step.done < step.at_risk) greenwood += greenwood_term(step);
    add_intervals(step, greenwood);
    survival.steps.push_back(step);
  }
  add_medians(survival);
  return survival;
}

// From the last step to the first, so that the area to the right of each is known.
RestrictedMean restricted_mean(const Survival& survival, double tau) {
  double area = 0;
  double variance = 0;
  double right = tau;
  for (std::size_t k = survival.steps.size(); k > 0; --k) {
    const auto& step = survival.steps[k - 1];
    if (step.time >= tau) continue;
    area += step.survival * (right - step.time);
    right = step.time;
    if (step.done < step.at_risk) variance += area * area * greenwood_term(step);
  }
  const double mean = area + right;
  const double se = std::sqrt(variance);
  const double width = z_of_95() * se;
  return {mean, se, {std::max(mean - width, 0.0), std::min(mean + width, tau)}};
}

}  // namespace promenade::analysis
