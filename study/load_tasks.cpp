// [[task]]: what a trial asks for, and when it is won.
#include <fmt/format.h>

#include <algorithm>

#include "motion/did_you_mean.h"
#include "study/fairness.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

constexpr double longest_limit_s = 86'400;
constexpr double least_threshold_m = 0.0001;
constexpr double largest_threshold_m = 10;
constexpr double longest_dwell_ms = 60'000;

std::vector<std::string> interface_names(const Study& study) {
  std::vector<std::string> names;
  for (const InterfaceUse& use : study.interfaces) names.push_back(use.name);
  return names;
}

std::vector<int> read_interface_list(const TomlTable& table, const Study& study) {
  std::vector<int> indices;
  const std::vector<std::string> names = interface_names(study);
  if (!table.has("interfaces")) {
    for (std::size_t i = 0; i < names.size(); ++i) indices.push_back(static_cast<int>(i));
    return indices;
  }
  const std::vector<TomlText> entries = table.texts("interfaces");
  for (const TomlText& entry : entries) {
    const auto found = std::find(names.begin(), names.end(), entry.text);
    const int index = static_cast<int>(found - names.begin());
    if (found == names.end() && !table.reader().whole()) continue;  // it may have had the name
    if (found == names.end()) {
      table.reader().add(entry.place, "there is no [[interface]] with the name \"" + entry.text +
                                          "\"" + did_you_mean(entry.text, names));
    } else if (std::find(indices.begin(), indices.end(), index) != indices.end()) {
      table.reader().add(entry.place, "interface \"" + entry.text + "\" is named twice");
    } else {
      indices.push_back(index);
    }
  }
  if (entries.empty() && table.is("interfaces", TomlValue::Kind::array)) {
    table.error("interfaces", "a task needs at least one interface");
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

// A target that is won before anything was touched measures nothing.
void refuse_won_targets(const TomlTable& table, std::string_view key,
                        const std::vector<Target>& targets, const Task& task,
                        const motion::MotionSpace& space) {
  const double threshold = *task.threshold_m;
  const std::vector<TomlTable> tables = table.tables(key);
  for (std::size_t i = 0; i < targets.size() && i < tables.size(); ++i) {
    if (!targets[i].weights) continue;
    const double start = start_distance(space, *targets[i].weights, task.distance);
    // "auto" goes down with the nearest target, to nothing at the average itself.
    if (start >= std::max(threshold, least_threshold_m)) continue;
    tables[i].error(fmt::format(
        "target \"{}\" is won before anything is touched: at the start D is {:.4f} m, below the "
        "threshold of {:.4f} m; ask for a walk further from the average or set a lower threshold",
        targets[i].name, start, threshold));
  }
}

void read_threshold(const TomlTable& table, const StudyContext& context, Task& task) {
  if (!table.has("threshold")) return;
  const bool automatic = table.is("threshold", TomlValue::Kind::text);
  if (automatic) {
    if (!table.choice("threshold", {"auto"}) || !context.space) return;
    task.threshold_m = automatic_threshold(*context.space, task);
  } else {
    task.threshold_m = table.number("threshold", least_threshold_m, largest_threshold_m);
  }
  if (!task.threshold_m || !context.space) return;
  refuse_won_targets(table, "targets", task.targets, task, *context.space);
  refuse_won_targets(table, "practice", task.practice, task, *context.space);
}

void read_match(const TomlTable& table, const StudyContext& context, Task& task) {
  task.targets = read_targets(table, "targets", context);
  task.practice = read_targets(table, "practice", context);
  if (!table.has("targets")) table.error(R"(a "match" task needs "targets")");
  const bool by_phase = table.choice("distance", {"time", "phase"}) == "phase";
  task.distance = by_phase ? motion::DistanceTimes::phase : motion::DistanceTimes::time;
  read_threshold(table, context, task);
  const double dwell_ms = table.number("dwell_ms", 0, longest_dwell_ms).value_or(500);
  task.dwell_us = static_cast<std::int64_t>(dwell_ms * 1000);
}

void read_find(const TomlTable& table, const StudyContext& context, Task& task) {
  task.targets = read_qualities(table, "qualities", context);
  task.practice = read_qualities(table, "practice", context);
  if (!table.has("qualities")) table.error(R"(a "find" task needs "qualities")");
}

// Whose panel shows the figure cannot be used blind.
void refuse_seeing(const TomlTable& table, const StudyContext& context, const Task& task) {
  for (const int index : task.interfaces) {
    const InterfaceUse& use = context.study.interfaces[static_cast<std::size_t>(index)];
    const InterfaceType* type = context.registry.find(use.type);
    if (!type || !type->shows_motion) continue;
    table.error("blind", "the interface \"" + use.name +
                             "\" shows the figure in its panel, so that this task cannot be "
                             "blind; name others in \"interfaces\"");
  }
}

// reference = "normal": an example that walks beside the others.
int read_reference(const TomlTable& table, const StudyContext& context) {
  const std::optional<std::string> name = table.text("reference");
  if (!name || !context.space) return -1;
  const int cycle = motion::find_cycle(context.space->set, *name);
  if (cycle < 0) {
    table.error("reference", "the motion set has no motion \"" + *name + "\"" +
                                 did_you_mean(*name, motion::names_of(context.space->set)));
  }
  return cycle;
}

Task read_task(const TomlTable& table, const StudyContext& context) {
  Task task;
  task.name = read_name(table);
  table.require("kind");
  const auto kind = table.choice("kind", {"match", "find"});
  task.limit_s = table.number("limit_s", 1, longest_limit_s);
  table.choice("start", {"average"});
  task.blind = table.boolean("blind").value_or(false);
  task.playback = table.boolean("playback").value_or(false);
  task.reference = read_reference(table, context);
  task.interfaces = read_interface_list(table, context.study);
  if (task.blind) refuse_seeing(table, context, task);
  // Without a kind the other keys tell: what is wrong with them is said all the same.
  const bool find = kind ? *kind == "find" : table.has("qualities");
  task.kind = find ? TaskKind::find : TaskKind::match;
  if (find) {
    read_find(table, context, task);
  } else if (kind || table.has("targets")) {
    read_match(table, context, task);
  } else {
    table.tables("practice");
    for (const char* key : {"threshold", "dwell_ms", "distance"}) table.scalar(key);
  }
  return task;
}

}  // namespace

std::vector<Task> read_tasks(const TomlTable& root, const StudyContext& context) {
  std::vector<Task> tasks;
  std::vector<std::string> names;
  if (!root.has("task")) root.error("a study needs at least one [[task]]");
  const std::vector<TomlTable> tables = root.tables("task");
  for (const TomlTable& table : tables) {
    tasks.push_back(read_task(table, context));
    names.push_back(tasks.back().name);
  }
  refuse_doubles(tables, names, "task");
  return tasks;
}

}  // namespace promenade::study
