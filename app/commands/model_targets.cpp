// `promenade model targets`: what every interface can do about the targets of a study.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/commands/model_parts.h"
#include "app/commands/numbers.h"
#include "app/commands/rating_source.h"
#include "app/print.h"
#include "app/registry.h"
#include "motion/files.h"
#include "study/reach_models.h"
#include "study/targets_csv.h"

namespace promenade::app {
namespace {

using study::StudyBundle;
using study::Target;
using study::Task;

struct Arguments {
  std::string study;
  RatingSource ratings, predict;
  std::string save;
  bool json = false, csv = false;
};

// One interface and one target.
struct Row {
  const Task* task = nullptr;
  const Target* target = nullptr;
  bool practice = false;
  const motion::ControlMap* map = nullptr;
  std::vector<std::string> used_as;  // the task's interfaces of this type
  double threshold_m = 0;
  study::Reach reach;
};

std::vector<std::string> uses_of(const StudyBundle& bundle, const Task& task,
                                 const std::string& type) {
  std::vector<std::string> names;
  for (const int index : task.interfaces) {
    const study::InterfaceUse& use = bundle.study.interfaces[static_cast<std::size_t>(index)];
    if (use.type == type) names.push_back(use.name);
  }
  return names;
}

// What is to be worked out, before it is.
std::vector<Row> open_rows(const StudyBundle& bundle, const study::ReachModels& models) {
  std::vector<Row> rows;
  for (const Task& task : bundle.study.tasks) {
    if (!study::has_target_motion(task.kind)) continue;
    const double threshold = study::judged_threshold(bundle.space, task);
    for (const bool practice : {true, false}) {
      for (const Target& target : practice ? task.practice : task.targets) {
        if (!target.weights) continue;
        for (const motion::ControlMap& map : models.maps) {
          rows.push_back({&task, &target, practice, &map, uses_of(bundle, task, map.name),
                          threshold, study::Reach{}});
        }
      }
    }
  }
  return rows;
}

void work_out(const study::ReachModels& models, const std::string& file, std::vector<Row>& rows) {
  const int count = static_cast<int>(rows.size());
  interrupted();  // from now on Ctrl-C is seen between two searches
  for (int done = 0; done < count; ++done) {
    Row& row = rows[static_cast<std::size_t>(done)];
    row.reach = study::reach(models, *row.map, *row.target, row.threshold_m, row.task->distance);
    show_progress("searches done:", done + 1, count);
    if (!interrupted()) continue;
    throw OutsideError(fmt::format("stopped after {} of {} searches of {}", done + 1, count, file));
  }
}

Json row_json(const Row& row) {
  return {{"interface", row.map->name},
          {"used", !row.used_as.empty()},
          {"used_as", row.used_as},
          {"controls", row.map->controls.size()},
          {"d_start", row.reach.start},
          {"d_best", row.reach.best},
          {"share_below", row.reach.share_below},
          {"settings", row.reach.settings}};
}

// Rows of one task and target stand together.
Json targets_json(const std::vector<Row>& rows, const Task& task) {
  Json targets = Json::array();
  const Target* last = nullptr;
  for (const Row& row : rows) {
    if (row.task != &task) continue;
    if (row.target != last) {
      targets.push_back({{"target", row.target->name},
                         {"practice", row.practice},
                         {"d_start", row.reach.start},
                         {"d_best_example", row.reach.best_example},
                         {"won_at_start", row.reach.start < row.threshold_m},
                         {"interfaces", Json::array()}});
    }
    last = row.target;
    targets.back()["interfaces"].push_back(row_json(row));
  }
  return targets;
}

Json tasks_json(const StudyBundle& bundle, const std::vector<Row>& rows) {
  Json tasks = Json::array();
  for (const Task& task : bundle.study.tasks) {
    if (!study::has_target_motion(task.kind)) continue;
    tasks.push_back({{"task", task.name},
                     {"distance", task.distance == motion::DistanceTimes::phase ? "phase" : "time"},
                     {"threshold_m", to_json(task.threshold_m)},
                     {"automatic_threshold_m", study::automatic_threshold(bundle.space, task)},
                     {"judged_by_m", study::judged_threshold(bundle.space, task)},
                     {"targets", targets_json(rows, task)}});
  }
  return tasks;
}

Json adjectives_json(const study::ReachModels& models) {
  if (const auto& predicted = models.predicted) {
    return {{"source", predicted->source},
            {"simulated", predicted->simulated},
            {"predicted", true},
            {"left_out_error", to_list(predicted->left_out_error)}};
  }
  if (!models.adjectives) return nullptr;
  return {{"source", models.adjectives->source},
          {"simulated", models.adjectives->simulated()},
          {"predicted", false}};
}

Json models_json(const StudyBundle& bundle, const study::ReachModels& models) {
  Json controls = Json::object();
  for (const motion::ControlMap& map : models.maps) controls[map.name] = map.controls;
  Json missing = Json::array();
  for (const auto& one : models.missing) {
    missing.push_back({{"interface", one.name}, {"reason", one.reason}});
  }
  Json json = {{"file", bundle.file},
               {"study", bundle.study.name},
               {"set", bundle.space.set.name},
               {"median_style_distance_m", study::median_style_distance(bundle.space)},
               {"controls", controls},
               {"adjectives", adjectives_json(models)},
               {"missing", missing}};
  return json;
}

std::string rows_csv(const std::vector<Row>& rows) {
  std::string text =
      "task,target,practice,interface,used,threshold_m,d_start,d_best,d_best_example,share_below\n";
  for (const Row& row : rows) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", csv_cell(row.task->name),
                        csv_cell(row.target->name), row.practice ? 1 : 0, row.map->name,
                        row.used_as.empty() ? 0 : 1, row.threshold_m, row.reach.start,
                        row.reach.best, row.reach.best_example, row.reach.share_below);
  }
  return text;
}

study::ReachModels models_of(const Arguments& given, const StudyBundle& bundle) {
  if (!given.predict.name.empty()) {
    const RatedSet rated = load_rated_set(given.predict);
    if (!rated.set)
      throw InputError("--predict", "needs the motions that were rated: name them with --set");
    return study::make_reach_models(
        bundle, study::predict_adjectives(rated.model, *rated.set, bundle.space.set));
  }
  if (given.ratings.name.empty()) return study::make_reach_models(bundle);
  study::AdjectiveModel model = load_rated_set(given.ratings).model;
  if (!model.agreement.agrees()) throw InputError("--ratings", describe(model.agreement));
  return study::make_reach_models(bundle, std::move(model));
}

// The targets that count and are the same for all participants, each name once.
std::vector<Target> fixed_targets(const StudyBundle& bundle) {
  std::vector<Target> targets;
  for (const Task& task : bundle.study.tasks) {
    for (const Target& target : task.targets) {
      if (!target.weights) continue;
      const auto same = std::find_if(targets.begin(), targets.end(), [&](const Target& other) {
        return other.name == target.name;
      });
      if (same == targets.end()) {
        targets.push_back(target);
      } else if (*same->weights != *target.weights) {
        throw InputError(bundle.file, "two tasks have different targets of the name \"" +
                                          target.name + "\"; a file of targets has it once");
      }
    }
  }
  return targets;
}

void save_targets(const StudyBundle& bundle, const std::string& file) {
  const std::vector<Target> targets = fixed_targets(bundle);
  if (targets.empty()) {
    throw InputError(bundle.file, "has no target motion that is the same for all participants");
  }
  write_file(file, study::targets_csv(targets, motion::names_of(bundle.space.set)));
}

void show(const Arguments& given) {
  const StudyBundle bundle = study::load_study(given.study, interfaces());
  print_problems(bundle.warnings);
  if (!given.save.empty()) return save_targets(bundle, given.save);
  const study::ReachModels models = models_of(given, bundle);
  std::vector<Row> rows = open_rows(bundle, models);
  work_out(models, bundle.file, rows);
  if (given.csv) return print_text(rows_csv(rows));
  Json document = models_json(bundle, models);
  document["tasks"] = tasks_json(bundle, rows);
  print_json(document);
}

}  // namespace

void add_model_targets(Command model) {
  Command command = model.add_subcommand(
      "targets", "What all five interfaces can do about the targets of a study");
  const auto given = std::make_shared<Arguments>();
  command.add_option("study", given->study, "A study file (.toml or .study)").required();
  const Option ratings =
      command.add_option("--ratings", given->ratings.name,
                         "DB or CSV behind the adjectives; built-in sets have simulated raters");
  command
      .add_option("--predict", given->predict.name,
                  "Adjectives of a set that nobody rated, from its features and from ratings of "
                  "other motions: builtin:B, DB or CSV")
      .excludes(ratings);
  command.add_option("--set", given->predict.set,
                     "The motions that the ratings of --predict are of: a file, or builtin:A");
  command.add_flag_callback(
      "--include-simulated",
      [given] {
        given->ratings.selection.include_simulated = true;
        given->predict.selection.include_simulated = true;
      },
      "DB: simulated participants, too");
  command.add_option("--save", given->save,
                     "Writes the targets into this CSV file, for { file = ... }, and no more");
  command.add_flag("--csv", given->csv, "A row for each target and interface");
  command.add_flag("--json", given->json, "One JSON document (as without it)").excludes("--csv");
  command.callback([given] { show(*given); });
}

}  // namespace promenade::app
