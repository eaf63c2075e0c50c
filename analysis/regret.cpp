#include "analysis/regret.h"

#include <algorithm>

#include "analysis/item.h"
#include "analysis/parallel.h"
#include "study/reach_models.h"

namespace promenade::analysis {
namespace {

using study::StudyBundle;

// One search, and where its result goes.
struct Search {
  const study::Task* task = nullptr;
  const study::Target* target = nullptr;
  int interface = 0;
};

std::vector<Search> searches_of(const study::Study& study, bool& drawn) {
  std::vector<Search> searches;
  for (const study::Task& task : study.tasks) {
    if (!study::has_target_motion(task.kind)) continue;
    for (const study::Target& target : task.targets) {
      drawn = drawn || !target.weights;
      if (!target.weights) continue;
      for (const int interface : task.interfaces) searches.push_back({&task, &target, interface});
    }
  }
  return searches;
}

Reachability search_all(const StudyBundle& bundle, const study::InterfaceRegistry& registry) {
  bool drawn = false;
  const std::vector<Search> searches = searches_of(bundle.study, drawn);
  Reachability result;
  result.rows.resize(searches.size());
  if (!searches.empty()) {
    const study::ReachModels models = study::make_reach_models(bundle);
    for_each_index(size_of(searches), [&](int i) {
      const Search& one = item(searches, i);
      const study::Reach reach = study::reach(bundle, registry, models, *one.task, one.interface,
                                              *one.target, one.task->threshold_m.value_or(0));
      item(result.rows, i) = {one.task->name, one.target->name,
                              item(bundle.study.interfaces, one.interface).name, reach.best};
    });
  }
  if (drawn) {
    result.missing =
        "Targets that were drawn anew for each participant have no best reachable D, and trials "
        "with them no regret.";
  }
  return result;
}

}  // namespace

std::optional<double> Reachability::best(const std::string& task, const std::string& target,
                                         const std::string& interface) const {
  for (const BestReachable& row : rows) {
    if (row.task == task && row.target == target && row.interface == interface) return row.best_m;
  }
  return std::nullopt;
}

Reachability find_reachable(const study::StudyBundle* stored,
                            const study::InterfaceRegistry& registry) {
  if (stored) return search_all(*stored, registry);
  return {{},
          "What each interface can reach could not be found, and there is no regret: this program "
          "cannot read the stored study."};
}

void add_regret(const Reachability& reachability, Dataset& data) {
  if (reachability.rows.empty()) return;
  const int d_final = data.measure("d_final");
  data.measures.push_back({"regret", "D above the best that the interface can reach", "m", "cm",
                           100, 1, MeasureKind::result});
  for (Trial& trial : data.trials) {
    const Task& task = item(data.tasks, trial.task);
    const auto best = reachability.best(task.name, item(task.targets, trial.target),
                                        item(data.interfaces, trial.interface));
    const std::optional<double>& d = item(trial.values, d_final);
    trial.values.push_back(best && d ? std::optional(*d - *best) : std::nullopt);
  }
}

}  // namespace promenade::analysis
