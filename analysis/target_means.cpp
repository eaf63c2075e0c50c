#include "analysis/target_means.h"

#include <set>

#include "analysis/item.h"
#include "analysis/statistics/differences.h"
#include "analysis/statistics/moments.h"

namespace promenade::analysis {
namespace {

using Values = std::vector<std::optional<double>>;

std::vector<int> places_of(const Dataset& data, int task) {
  std::vector<int> places;
  const int targets = size_of(item(data.tasks, task).targets);
  for (int target = 0; target < targets; ++target) places.push_back(target);
  if (targets != 1) places.push_back(-1);
  return places;
}

}  // namespace

std::vector<TargetMean> target_means(const Dataset& data, int measure, int task) {
  std::vector<TargetMean> means;
  for (const int target : places_of(data, task)) {
    for (int i = 0; i < size_of(data.interfaces); ++i) {
      const Moments all = moments_of(present(mean_per_person(data, measure, i, task, target)));
      if (all.mean) means.push_back({i, target, all.n, *all.mean, all.sd});
    }
  }
  return means;
}

std::vector<MeanDifference> mean_differences(const Dataset& data, int measure, int task,
                                             int reference) {
  std::vector<MeanDifference> result;
  for (const int target : places_of(data, task)) {
    const Values base = mean_per_person(data, measure, reference, task, target);
    for (int i = 0; i < size_of(data.interfaces); ++i) {
      if (i == reference) continue;
      const Values values = mean_per_person(data, measure, i, task, target);
      const Moments all = moments_of(paired_differences(values, base).values, 0.90);
      if (all.mean) result.push_back({i, target, all.n, *all.mean, all.mean_ci});
    }
  }
  return result;
}

int reference_interface(const Dataset& data, int task) {
  std::set<int> used;
  for (const Trial& trial : data.trials) {
    if (trial.task == task) used.insert(trial.interface);
  }
  if (used.size() < 2) return -1;
  for (const int i : used) {
    if (item(data.interfaces, i).find("weight") != std::string::npos) return i;
  }
  return *used.rbegin();
}

}  // namespace promenade::analysis
