// [[task]] of kind "rate": which motions are rated, by what, and how many by each person.
#include <fmt/format.h>

#include "study/study_parts.h"

namespace promenade::study {
namespace {

constexpr int most_targets = 100'000;

// each = 10: every participant rates that many of the targets; repeats = 2: so many of these
// come a second time.
void read_split(const TomlTable& table, const StudyContext& context, Task& task) {
  const auto targets = static_cast<int>(task.targets.size());
  const auto each = table.integer("each", 1, most_targets);
  const auto repeats = table.integer("repeats", 0, most_targets);
  if (targets == 0) return;
  if (each && *each > targets) {
    table.error("each",
                fmt::format("nobody can rate {} motions where the task has {}; take 1 to {}", *each,
                            targets, targets));
    return;
  }
  const int rated = each ? static_cast<int>(*each) : targets;
  if (repeats && *repeats > rated) {
    table.error("repeats",
                fmt::format("{} motions cannot come again where each person rates {}; take 0 to {}",
                            *repeats, rated, rated));
    return;
  }
  task.repeats = repeats ? static_cast<int>(*repeats) : 0;
  if (!each && task.repeats == 0) return;
  Rng rng(context.study.seed, 0, "split:" + task.name);
  task.split = make_split(targets, rated, rng);
}

}  // namespace

void read_rate(const TomlTable& table, const StudyContext& context, Task& task) {
  if (table.has("interfaces")) {
    table.error("interfaces", "nothing is made in a \"rate\" task, so that it has no interfaces");
  }
  task.interfaces.clear();
  task.has_done = true;
  table.require("instrument");
  task.instrument = context.instruments.find(table, "instrument");
  const TargetRules anywhere{task.name, {}, 0.0, true};
  task.targets = read_targets(table, "targets", context, anywhere);
  task.practice = read_targets(table, "practice", context, anywhere);
  if (!table.has("targets")) table.error(R"(a "rate" task needs "targets", the motions to rate)");
  read_split(table, context, task);
}

}  // namespace promenade::study
