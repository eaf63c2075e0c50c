// [[task]]: what a trial asks for, and when it is won.
#include <fmt/format.h>

#include <algorithm>

#include "motion/did_you_mean.h"
#include "study/deal.h"
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

// D at the start; of a target that is drawn later the least that it can be.
std::optional<double> start_of(const Target& target, const Task& task,
                               const motion::MotionSpace& space) {
  if (target.draw) return target.least_start_m;
  if (!target.weights) return std::nullopt;
  return start_distance(space, *target.weights, task.distance);
}

// A target that is won before anything was touched measures nothing.
void refuse_won_targets(const TomlTable& table, const std::vector<Target>& targets,
                        const Task& task, const motion::MotionSpace& space) {
  for (const Target& target : targets) {
    const auto start = start_of(target, task, space);
    // "auto" goes down with the nearest target, to nothing at the average itself.
    if (!start || *start >= std::max(*task.threshold_m, least_threshold_m)) continue;
    if (!table.reader().whole()) continue;
    table.reader().add(
        target.place,
        fmt::format("target \"{}\" is won before anything is touched: at the start D {} {:.4f} m, "
                    "below the threshold of {:.4f} m; ask for a walk further from the average or "
                    "set a lower threshold",
                    target.name, target.draw ? "can be" : "is", *start, *task.threshold_m));
  }
}

// A number is known before the targets, which are drawn by it; "auto" comes after them.
void read_fixed_threshold(const TomlTable& table, Task& task) {
  if (!table.has("threshold") || table.is("threshold", TomlValue::Kind::text)) return;
  task.threshold_m = table.number("threshold", least_threshold_m, largest_threshold_m);
}

void read_automatic_threshold(const TomlTable& table, const StudyContext& context, Task& task) {
  if (!table.is("threshold", TomlValue::Kind::text)) return;
  if (!table.choice("threshold", {"auto"}) || !context.space) return;
  task.threshold_m = automatic_threshold(*context.space, task);
}

void read_match_targets(const TomlTable& table, const StudyContext& context, Task& task) {
  const TargetRules rules{task.name, task.distance, task.threshold_m};
  task.targets = read_targets(table, "targets", context, rules);
  task.practice = read_targets(table, "practice", context, rules);
  const bool guess = task.kind == TaskKind::guess;
  if (!table.has("targets")) {
    table.error(std::string("a \"") + (guess ? "guess" : "match") + "\" task needs \"targets\"");
  }
}

// deal = "rotated": lists of equal difficulty, as many as interfaces.
void read_deal(const TomlTable& table, const StudyContext& context, Task& task) {
  if (table.choice("deal", {"same", "rotated"}) != "rotated") return;
  task.deal = Deal::rotated;
  const std::size_t lists = task.interfaces.size();
  if (lists == 0 || task.targets.empty() || !table.reader().ok()) return;
  if (task.targets.size() % lists != 0) {
    const std::size_t rounds = std::max<std::size_t>(1, task.targets.size() / lists);
    table.error("deal",
                fmt::format("{} targets cannot be dealt evenly to {} interfaces; take {} "
                            "or {}",
                            task.targets.size(), lists, rounds * lists, (rounds + 1) * lists));
    return;
  }
  std::vector<double> difficulties;
  for (const Target& target : task.targets) {
    difficulties.push_back(context.space ? start_of(target, task, *context.space).value_or(0) : 0);
  }
  task.lists = deal_lists(difficulties, static_cast<int>(lists));
}

void read_match(const TomlTable& table, const StudyContext& context, bool has_targets, Task& task) {
  const bool by_phase = table.choice("distance", {"time", "phase"}) == "phase";
  task.distance = by_phase ? motion::DistanceTimes::phase : motion::DistanceTimes::time;
  read_fixed_threshold(table, task);
  if (!has_targets) {
    read_match_targets(table, context, task);
    read_deal(table, context, task);
  }
  read_automatic_threshold(table, context, task);
  if (task.threshold_m && context.space) {
    refuse_won_targets(table, task.targets, task, *context.space);
    refuse_won_targets(table, task.practice, task, *context.space);
  }
  const double dwell_ms = table.number("dwell_ms", 0, longest_dwell_ms).value_or(500);
  task.dwell_us = static_cast<std::int64_t>(dwell_ms * 1000);
}

void read_find(const TomlTable& table, const StudyContext& context, Task& task) {
  task.targets = read_qualities(table, "qualities", context);
  task.practice = read_qualities(table, "practice", context);
  if (!table.has("qualities")) table.error(R"(a "find" task needs "qualities")");
  read_deal(table, context, task);
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

TaskKind kind_of(const TomlTable& table, const std::optional<std::string>& word) {
  // Without a kind the other keys tell: what is wrong with them is said all the same.
  if (!word) return table.has("qualities") ? TaskKind::find : TaskKind::match;
  if (*word == "find") return TaskKind::find;
  if (*word == "guess") return TaskKind::guess;
  return *word == "rate" ? TaskKind::rate : TaskKind::match;
}

// start = "average", or the name of a task of kind "guess" before it, whose targets, practice
// and lists it takes over.
void read_start(const TomlTable& table, const std::vector<Task>& before, Task& task) {
  const auto name = table.text("start");
  if (!name || *name == "average") return;
  std::vector<std::string> guesses;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].kind != TaskKind::guess) continue;
    guesses.push_back(before[i].name);
    if (before[i].name == *name) task.start_guess = static_cast<int>(i);
  }
  if (task.start_guess >= 0) return;
  guesses.emplace_back("average");
  table.error("start",
              "\"start\" is \"average\", or the name of a task of kind \"guess\" that "
              "stands before this one, not \"" +
                  *name + "\"" + did_you_mean(*name, guesses));
}

// With an interface that does not do the guess there is nothing to begin from.
void refuse_unguessed(const TomlTable& table, const StudyContext& context, const Task& guess,
                      const Task& task) {
  for (const int index : task.interfaces) {
    const auto& known = guess.interfaces;
    if (std::find(known.begin(), known.end(), index) != known.end()) continue;
    table.error("start", "nobody does the task \"" + guess.name + "\" with the interface \"" +
                             context.study.interfaces[static_cast<std::size_t>(index)].name +
                             "\", so that there is no guess to begin from");
  }
}

void take_targets(const TomlTable& table, const Task& guess, Task& task) {
  for (const char* key : {"targets", "practice", "deal"}) {
    if (!table.has(key)) continue;
    table.error(key, std::string("a task that begins from a guess has the \"") + key +
                         "\" of that task; leave this out");
  }
  for (const int interface : task.interfaces) {
    const std::vector<int>& guessed = guess.interfaces;
    if (std::find(guessed.begin(), guessed.end(), interface) != guessed.end()) continue;
    table.error("interfaces", "a task that begins from a guess has no other interfaces than \"" +
                                  guess.name + "\"");
    break;
  }
  task.targets = guess.targets;
  task.practice = guess.practice;
  task.deal = guess.deal;
  task.lists = guess.lists;
}

void read_by_kind(const TomlTable& table, const StudyContext& context,
                  const std::vector<Task>& before, bool known, Task& task) {
  read_start(table, before, task);
  if (task.kind == TaskKind::find) return read_find(table, context, task);
  if (task.kind == TaskKind::rate) return read_rate(table, context, task);
  if (task.start_guess >= 0) {
    const Task& guess = before[static_cast<std::size_t>(task.start_guess)];
    refuse_unguessed(table, context, guess, task);
    take_targets(table, guess, task);
  } else if (!known && !table.has("targets")) {
    table.tables("practice");
    for (const char* key : {"threshold", "dwell_ms", "distance", "deal"}) table.scalar(key);
    return;
  }
  read_match(table, context, task.start_guess >= 0, task);
}

Task read_task(const TomlTable& table, const StudyContext& context,
               const std::vector<Task>& before) {
  Task task;
  task.name = read_name(table);
  table.require("kind");
  const auto kind = table.choice("kind", {"match", "find", "guess", "rate"});
  task.kind = kind_of(table, kind);
  task.limit_s = table.number("limit_s", 1, longest_limit_s);
  task.blind = table.boolean("blind").value_or(false) || task.kind == TaskKind::guess;
  task.playback = table.boolean("playback").value_or(false);
  task.has_done = table.boolean("done").value_or(true);
  task.reference = read_reference(table, context);
  task.interfaces = read_interface_list(table, context.study);
  if (task.blind) refuse_seeing(table, context, task);
  read_by_kind(table, context, before, kind.has_value(), task);
  if (!task.has_done && !task.limit_s && !task.threshold_m) {
    table.error("done", "without Done, a limit_s or a threshold a trial would never end");
  }
  return task;
}

// A guess comes before what begins from it, whatever the order.
void refuse_early_starts(const std::vector<TomlTable>& tables, const Study& study,
                         const std::vector<Task>& tasks) {
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].start_guess < 0 || study.task_order == Sequence::fixed) continue;
    tables[i].error("start", "with task_order = \"random\" the guess may come after this task");
  }
}

}  // namespace

std::vector<Task> read_tasks(const TomlTable& root, const StudyContext& context) {
  std::vector<Task> tasks;
  std::vector<std::string> names;
  const std::vector<TomlTable> tables = root.tables("task");
  for (const TomlTable& table : tables) {
    tasks.push_back(read_task(table, context, tasks));
    names.push_back(tasks.back().name);
  }
  const bool only_rated = !tasks.empty() && std::all_of(tasks.begin(), tasks.end(), [](auto& one) {
    return one.kind == TaskKind::rate;
  });
  if (!root.has("interface") && !only_rated) {
    root.error("a study needs at least one [[interface]]");
  }
  if (!root.has("task")) root.error("a study needs at least one [[task]]");
  refuse_doubles(tables, names, "task");
  refuse_early_starts(tables, context.study, tasks);
  return tasks;
}

}  // namespace promenade::study
