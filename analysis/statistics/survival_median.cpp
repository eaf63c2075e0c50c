#include "analysis/statistics/survival_median.h"

namespace promenade::analysis {

MedianTimeInterval median_time_interval(const Survival& survival) {
  MedianTimeInterval interval;
  for (const SurvivalStep& step : survival.steps) {
    if (!step.loglog) continue;
    if (!interval.lower && step.loglog->lower <= 0.5) interval.lower = step.time;
    if (!interval.upper && step.loglog->upper <= 0.5) interval.upper = step.time;
  }
  return interval;
}

}  // namespace promenade::analysis
