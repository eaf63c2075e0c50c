#include "analysis/summaries.h"

#include <cmath>

#include "analysis/item.h"
#include "analysis/statistics/median.h"
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
  return ratio;
}

std::vector<double> present(const std::vector<std::optional<double>>& values) {
  std::vector<double> result;
  for (const auto& value : values) {
    if (value) result.push_back(*value);
  }
  return result;
}

void describe(Summary& summary) {
  const std::vector<double> values = present(summary.values);
  summary.n = size_of(values);
  if (values.empty()) return;
  const auto count = static_cast<double>(values.size());
  double sum = 0;
  for (const double value : values) sum += value;
  summary.mean = sum / count;
  double squares = 0;
  for (const double value : values) squares += (value - *summary.mean) * (value - *summary.mean);
  if (values.size() > 1) summary.sd = std::sqrt(squares / (count - 1));
  summary.median = median_of(values);
  summary.median_ci = median_interval(values, 0.95);
}

}  // namespace

std::vector<FailureRatio> failure_ratios(const Dataset& data) {
  std::vector<FailureRatio> ratios;
  for (int task = 0; task < size_of(data.tasks); ++task) {
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

}  // namespace promenade::analysis
