// Where one entry of `targets` stands for several: { random = ... } and
// { all = true }.
#include <fmt/format.h>

#include <algorithm>

#include "study/study_parts.h"
#include "study/target_draw.h"

namespace promenade::study {
namespace {

constexpr int most_targets = 100;
constexpr int most_draws = 1000;
constexpr int least_far_starts = tried_starts / 20;

// What { random = ... } says.
struct Lot {
  std::string name;
  DrawModel model = DrawModel::adjectives;
  DrawRules rules;
  bool each = false;  // drawn for every participant
};

DrawModel model_of(const std::string& word) {
  if (word == "features") return DrawModel::features;
  if (word == "weights") return DrawModel::weights;
  if (word == "examples") return DrawModel::examples;
  return word == "pca" ? DrawModel::pca : DrawModel::adjectives;
}

// Nothing after a problem.
std::optional<Lot> read_lot(const TomlTable& table, const TargetRules& task) {
  Lot lot;
  const auto model =
      table.choice("random", {"adjectives", "features", "weights", "pca", "examples"});
  const auto kept = table.integer("count", 1, most_targets);
  const auto draws = table.integer("draw", 1, most_draws);
  const auto per = table.choice("per", {"study", "participant"});
  table.require("count");
  lot.name = table.text("name").value_or(model.value_or(""));
  refuse_unsafe_name(table, "name", lot.name);
  if (kept && draws && *draws < *kept) {
    table.error("draw",
                fmt::format("\"draw\" is {}, but {} of them are to be kept", *draws, *kept));
    return std::nullopt;
  }
  if (!model || !kept || (table.has("draw") && !draws)) return std::nullopt;
  lot.model = model_of(*model);
  lot.rules.kept = static_cast<int>(*kept);
  lot.rules.draws = static_cast<int>(draws.value_or(*kept));
  lot.rules.times = task.times;
  lot.each = per == "participant";
  return lot;
}

// Or an empty function and a problem at "random".
DrawWalk source_of(const TomlTable& table, const Lot& lot, const StudyContext& context) {
  const bool rated = lot.model == DrawModel::adjectives;
  const auto adjectives = rated ? context.adjectives() : nullptr;
  WalkSource source = make_walk_source(lot.model, *context.space, adjectives.get());
  if (!source.draw) {
    table.error("random", fmt::format("nothing can be drawn from \"{}\": {}", *table.text("random"),
                                      source.problem));
  }
  return std::move(source.draw);
}

// No example is drawn twice: there must be enough of them, and no more are drawn than there are.
bool has_enough_examples(const TomlTable& table, const StudyContext& context, Lot& lot) {
  if (lot.model != DrawModel::examples) return true;
  const int far = count_far_examples(*context.bank, lot.rules.times, lot.rules.least_start_m);
  lot.rules.draws = std::min(lot.rules.draws, far);
  if (far >= lot.rules.kept) return true;
  table.error("count", fmt::format("{} walks of the set are asked for, but only {} of them begin "
                                   "above the threshold of {:.4f} m",
                                   lot.rules.kept, far, lot.rules.least_start_m));
  return false;
}

bool begins_far(const TomlTable& table, const Lot& lot, const DrawWalk& draw,
                const StudyContext& context) {
  const int far = count_far_starts(*context.bank, draw, lot.rules.times, lot.rules.least_start_m);
  if (far >= least_far_starts) return true;
  table.error("random",
              fmt::format("only {} of {} walks drawn by \"{}\" begin above the threshold of {:.4f} "
                          "m; set a lower one, or draw from another model",
                          far, tried_starts, *table.text("random"), lot.rules.least_start_m));
  return false;
}

std::vector<Target> open_targets(const TomlTable& table, const Lot& lot,
                                 const std::string& stream) {
  std::vector<Target> targets(static_cast<std::size_t>(lot.rules.kept));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i].name = lot.name + std::to_string(i + 1);
    targets[i].place = table.place();
    targets[i].stream = stream;
  }
  return targets;
}

// All of one lot come from one stream, so that each is one of those that were kept.
void draw_for_each(const Lot& lot, const DrawWalk& draw, const motion::PoseBank& shared,
                   std::vector<Target>& targets) {
  const auto bank = std::make_shared<const motion::PoseBank>(shared);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets[i].least_start_m = lot.rules.least_start_m;
    targets[i].draw = [bank, draw, rules = lot.rules, i](Rng& rng) {
      return draw_targets(*bank, draw, rules, rng)[i];
    };
  }
}

void draw_for_all(const Lot& lot, const DrawWalk& draw, const StudyContext& context,
                  const std::string& task, std::vector<Target>& targets) {
  Rng rng(context.study.seed, 0, "targets:" + task + ":" + targets.front().stream);
  const auto walks = draw_targets(*context.bank, draw, lot.rules, rng);
  for (std::size_t i = 0; i < targets.size(); ++i) targets[i].weights = walks[i];
}

// A walk of the set goes by its own name unless the study has another one.
void name_examples(const TomlTable& table, const Lot& lot, const motion::MotionSet& set,
                   std::vector<Target>& targets) {
  if (lot.model != DrawModel::examples || lot.each || table.has("name")) return;
  for (Target& target : targets) {
    Eigen::Index cycle = 0;
    target.weights->maxCoeff(&cycle);
    target.name = set.cycles[static_cast<std::size_t>(cycle)].name;
  }
}

std::vector<Target> drawn(const TomlTable& table, Lot lot, const DrawWalk& draw,
                          const StudyContext& context, const std::string& task,
                          std::vector<Target> targets) {
  if (!has_enough_examples(table, context, lot) || !begins_far(table, lot, draw, context)) {
    return targets;
  }
  if (lot.each) {
    draw_for_each(lot, draw, *context.bank, targets);
  } else {
    draw_for_all(lot, draw, context, task, targets);
    name_examples(table, lot, context.space->set, targets);
  }
  return targets;
}

}  // namespace

std::vector<Target> read_random_targets(const TomlTable& table, std::string_view key,
                                        const StudyContext& context, const TargetRules& task) {
  std::optional<Lot> lot = read_lot(table, task);
  if (!lot) return {};
  // Practice never meets the targets that count.
  std::vector<Target> targets = open_targets(table, *lot, std::string(key) + ":" + lot->name);
  table.text("kept_in");  // known, though the walks may not be
  if (!context.space) return targets;
  if (auto kept = read_kept_targets(table, lot->rules.kept, lot->each, context)) return *kept;
  const DrawWalk draw = source_of(table, *lot, context);
  if (!draw) return targets;
  lot->rules.least_start_m =
      task.least_start_m ? *task.least_start_m
                         : usual_least_start(*context.space, *context.bank, draw, task.times);
  return drawn(table, *lot, draw, context, task.task, std::move(targets));
}

std::vector<Target> read_all_examples(const TomlTable& table, const StudyContext& context) {
  const auto all = table.boolean("all");
  if (all && !*all) table.error("all", "\"all\" is true, or left out");
  if (!context.space) return {};
  const motion::MotionSet& set = context.space->set;
  std::vector<Target> targets(static_cast<std::size_t>(set.size()));
  for (int i = 0; i < set.size(); ++i) {
    Target& target = targets[static_cast<std::size_t>(i)];
    target.name = set.cycles[static_cast<std::size_t>(i)].name;
    target.weights = Eigen::VectorXd::Unit(set.size(), i);
    target.place = table.place();
  }
  return targets;
}

}  // namespace promenade::study
