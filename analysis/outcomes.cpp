#include "analysis/outcomes.h"

#include <algorithm>
#include <cmath>

#include "analysis/item.h"
#include "analysis/samples.h"
#include "motion/did_you_mean.h"
#include "motion/problem.h"
#include "study/asked_quality.h"
#include "study/migrate.h"
#include "study/stored_study.h"

namespace promenade::analysis {
namespace {

using study::StudyBundle;

constexpr std::size_t name_digits = 12;  // of a uuid: two of a million trials share them never

StudyBundle stored_study(const std::string& file, const study::InterfaceRegistry& registry) {
  study::Database database = study::open_log(file);
  auto stored = study::read_newest_study(database, registry);
  if (!stored) throw InputError(file, "this program cannot read the stored study");
  return std::move(*stored);
}

void refuse_unknown(const std::string& option, const std::vector<std::string>& wanted,
                    const std::vector<std::string>& known) {
  for (const std::string& name : wanted) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw InputError(option,
                     "nobody did anything with \"" + name + "\"" + did_you_mean(name, known));
  }
}

bool is_wanted(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

std::vector<std::string> names_of(const std::vector<Task>& tasks) {
  std::vector<std::string> names;
  for (const Task& task : tasks) names.push_back(task.name);
  return names;
}

const study::Target* target_of(const StudyBundle& stored, const Dataset& data, const Trial& trial) {
  const Task& task = item(data.tasks, trial.task);
  const study::Task* asked = study::find_task(stored.study, task.name);
  if (!asked || asked->kind != study::TaskKind::find) return nullptr;
  for (const study::Target& target : asked->targets) {
    if (target.name == item(task.targets, trial.target)) return &target;
  }
  return nullptr;
}

// Adds what one database says about the outcomes of this study.
void put_ratings(const std::string& file, const study::AdjectiveModel& model, const Log& log,
                 const StudyBundle& stored, const Dataset& data, std::vector<double>& sums,
                 std::vector<int>& counts) {
  const std::vector<std::string>& rated = model.table.motions;
  int known = 0;
  for (std::size_t i = 0; i < data.trials.size(); ++i) {
    const Trial& trial = data.trials[i];
    const auto at =
        std::find(rated.begin(), rated.end(), outcome_name(item(log.trials, trial.logged).uuid));
    const study::Target* target = at == rated.end() ? nullptr : target_of(stored, data, trial);
    if (!target) continue;
    ++known;
    const auto pair = study::asked_pair(model.table.pairs, *target);
    if (!pair) continue;
    const double mean = study::asked_ratings(model, *pair)(at - rated.begin());
    if (!std::isfinite(mean)) continue;
    sums[i] += mean;
    ++counts[i];
  }
  if (known == 0) {
    throw InputError(file,
                     "rates nothing that was made in this study; `promenade model outcomes` "
                     "writes what was made as the targets of a study of kind \"rate\"");
  }
}

}  // namespace

std::string outcome_name(const std::string& trial_uuid) {
  std::string digits = trial_uuid;
  digits.erase(std::remove(digits.begin(), digits.end(), '-'), digits.end());
  return "made-" + digits.substr(0, name_digits);
}

Outcomes outcomes_of(const std::vector<std::string>& databases, const SelectionOptions& options,
                     const study::InterfaceRegistry& registry, const OutcomeChoice& choice) {
  const Log log = read_log(databases);
  const Dataset data = make_dataset(log, select(log, options));
  const StudyBundle stored = stored_study(databases[0], registry);
  refuse_unknown("--task", choice.tasks, names_of(data.tasks));
  refuse_unknown("--interface", choice.interfaces, data.interfaces);
  std::vector<bool> tasks;
  for (const Task& task : data.tasks) {
    const study::Task* asked = study::find_task(stored.study, task.name);
    const bool finds = asked && asked->kind == study::TaskKind::find;
    tasks.push_back(choice.tasks.empty() ? finds : is_wanted(choice.tasks, task.name));
  }
  const auto finals = final_weights(log, data, stored, tasks);
  Outcomes outcomes;
  outcomes.motions = motion::names_of(stored.space.set);
  for (std::size_t i = 0; i < finals.size(); ++i) {
    const Trial& trial = data.trials[i];
    if (!finals[i] || !is_wanted(choice.interfaces, item(data.interfaces, trial.interface))) {
      continue;
    }
    study::Target target;
    target.name = outcome_name(item(log.trials, trial.logged).uuid);
    target.weights = *finals[i] / finals[i]->sum();
    outcomes.targets.push_back(std::move(target));
  }
  if (outcomes.targets.empty()) {
    throw InputError(databases[0],
                     "nothing was made in a find task by people who count; --task names another "
                     "task, --include-simulated and --include-pilot count such people");
  }
  std::sort(outcomes.targets.begin(), outcomes.targets.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return outcomes;
}

void add_rated_quality(const SelectionOptions& options, const Log& log, const StudyBundle* stored,
                       Dataset& data) {
  if (!stored || options.rated_by.empty()) return;
  std::vector<double> sums(data.trials.size(), 0.0);
  std::vector<int> counts(data.trials.size(), 0);
  bool simulated = false;
  for (const std::string& file : options.rated_by) {
    study::RatingSelection selection;
    selection.include_simulated = options.include_simulated;
    selection.include_pilot = options.include_pilot;
    study::RatingsTable table = study::read_database_ratings(file, selection).table;
    simulated = simulated || table.simulated;
    put_ratings(file, study::make_adjective_model(std::move(table), file), log, *stored, data, sums,
                counts);
  }
  data.measures.push_back(
      {"rated_quality",
       simulated ? "asked quality, rated (simulated)" : "asked quality, rated by others", "", "", 1,
       2, MeasureKind::result});
  for (std::size_t i = 0; i < data.trials.size(); ++i) {
    data.trials[i].values.push_back(counts[i] > 0 ? std::optional(sums[i] / counts[i])
                                                  : std::nullopt);
  }
}

}  // namespace promenade::analysis
