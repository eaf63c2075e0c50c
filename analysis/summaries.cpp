#include "analysis/summaries.h"

#include <algorithm>

#include "analysis/failure_tests.h"
#include "analysis/item.h"
#include "analysis/statistics/median.h"
#include "analysis/statistics/moments.h"
#include "analysis/statistics/proportion.h"

namespace promenade::analysis {
namespace {

FailureRatio failures_at(const Dataset& data, int task, int target, int interface) {
  FailureRatio ratio;
  ratio.task = task;
  ratio.target = target;
  ratio.interface = interface;
  for (const Trial& trial : data.trials) {
    if (trial.task != task || trial.interface != interface) continue;
    if (target >= 0 && trial.target != target) continue;
    ++ratio.trials;
    ratio.failed += trial.failed ? 1 : 0;
    ratio.timeouts += trial.outcome == "timeout" ? 1 : 0;
  }
  ratio.wilson = wilson_interval(ratio.failed, ratio.trials);
  ratio.clopper_pearson = clopper_pearson_interval(ratio.failed, ratio.trials);
  return ratio;
}

void describe(Summary& summary) {
  const std::vector<double> values = present(summary.values);
  summary.n = size_of(values);
  if (values.empty()) return;
  const Moments moments = moments_of(values);
  summary.mean = moments.mean;
  summary.sd = moments.sd;
  summary.median = median_of(values);
  summary.median_ci = median_interval(values, 0.95);
}

// At the place that `place` names; n stays 0 where there is no value.
TargetSummary describe_at(const Dataset& data, TargetSummary place) {
  const std::vector<double> values =
      present(mean_per_person(data, place.measure, place.interface, place.task, place.target));
  if (values.empty()) return place;
  const Moments moments = moments_of(values);
  place.n = size_of(values);
  place.mean = *moments.mean;
  place.sd = moments.sd;
  place.median = *median_of(values);
  place.least = *std::min_element(values.begin(), values.end());
  place.most = *std::max_element(values.begin(), values.end());
  return place;
}

std::vector<TargetSummary> summaries_in(const Dataset& data, int measure, int task) {
  std::vector<TargetSummary> all;
  for (int target = 0; target < size_of(item(data.tasks, task).targets); ++target) {
    for (int i = 0; i < size_of(data.interfaces); ++i) {
      const TargetSummary one = describe_at(data, {measure, task, target, i});
      if (one.n > 0) all.push_back(one);
    }
  }
  return all;
}

}  // namespace

std::vector<FailureRatio> failure_ratios(const Dataset& data) {
  std::vector<FailureRatio> ratios;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    if (!can_fail(data, task)) continue;
    const auto& targets = item(data.tasks, task).targets;
    for (int target = -1; target < size_of(targets); ++target) {
      for (int i = 0; i < size_of(data.interfaces); ++i) {
        const FailureRatio ratio = failures_at(data, task, target, i);
        if (ratio.trials > 0) ratios.push_back(ratio);
      }
    }
  }
  return ratios;
}

std::vector<Summary> summaries(const Dataset& data) {
  std::vector<Summary> all;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    for (int measure = 0; measure < size_of(data.measures); ++measure) {
      for (int i = 0; i < size_of(data.interfaces); ++i) {
        Summary summary;
        summary.measure = measure;
        summary.task = task;
        summary.interface = i;
        summary.values = mean_per_person(data, measure, i, task);
        describe(summary);
        if (summary.n > 0) all.push_back(std::move(summary));
      }
    }
  }
  return all;
}

std::vector<TargetSummary> target_summaries(const Dataset& data) {
  std::vector<TargetSummary> all;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    for (int measure = 0; measure < size_of(data.measures); ++measure) {
      if (!data.occurs(measure, task)) continue;
      const std::vector<TargetSummary> more = summaries_in(data, measure, task);
      all.insert(all.end(), more.begin(), more.end());
    }
  }
  return all;
}

}  // namespace promenade::analysis
