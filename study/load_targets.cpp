// Targets of match tasks and qualities of find tasks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "motion/did_you_mean.h"
#include "motion/models/adjective_pairs.h"
#include "study/adjective_model.h"
#include "study/study_parts.h"

namespace promenade::study {
namespace {

constexpr double sum_tolerance = 1e-6;
constexpr double largest_weight = 100;

// The cycles that a name stands for: the one of this name, or all of this style.
std::vector<int> cycles_of(const motion::MotionSet& set, const std::string& name) {
  const int one = motion::find_cycle(set, name);
  if (one >= 0) return {one};
  std::vector<int> cycles;
  for (int i = 0; i < set.size(); ++i) {
    if (set.cycles[static_cast<std::size_t>(i)].style == name) cycles.push_back(i);
  }
  return cycles;
}

std::vector<std::string> names_in(const motion::MotionSet& set) {
  std::vector<std::string> names;
  for (const motion::Cycle& cycle : set.cycles) {
    names.push_back(cycle.name);
    if (cycle.style != cycle.name) names.push_back(cycle.style);
  }
  return names;
}

// Adds `share` of the named walk; a style of several cycles is their mean.
bool add_walk(const TomlTable& table, std::string_view key, const std::string& name, double share,
              const motion::MotionSet& set, Eigen::VectorXd& weights) {
  const std::vector<int> cycles = cycles_of(set, name);
  for (const int cycle : cycles) weights(cycle) += share / static_cast<double>(cycles.size());
  if (!cycles.empty()) return true;
  table.error(key, "the motion set \"" + set.name + "\" has no walk \"" + name + "\"" +
                       did_you_mean(name, names_in(set)));
  return false;
}

std::optional<Eigen::VectorXd> read_weights(const TomlTable& target, const StudyContext& context) {
  const auto table = target.table("weights");
  if (!table) return std::nullopt;
  bool numbers = true, known = true;
  double sum = 0;
  Eigen::VectorXd weights =
      context.space ? Eigen::VectorXd::Zero(context.space->set.size()) : Eigen::VectorXd::Zero(1);
  for (const std::string& name : table->keys()) {
    const auto share = table->number(name, -largest_weight, largest_weight);
    numbers = numbers && share;
    sum += share.value_or(0);
    if (!share || !context.space) continue;
    known = add_walk(*table, name, name, *share, context.space->set, weights) && known;
  }
  if (numbers && std::abs(sum - 1) > sum_tolerance) {
    target.error("weights", fmt::format("the weights sum to {}, but must sum to 1", sum));
    return std::nullopt;
  }
  if (!numbers || !known || !context.space) return std::nullopt;
  return weights / sum;
}

std::optional<Eigen::VectorXd> read_example(const TomlTable& target, const StudyContext& context) {
  const auto name = target.text("example");
  if (!name || !context.space) return std::nullopt;
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(context.space->set.size());
  if (!add_walk(target, "example", *name, 1, context.space->set, weights)) return std::nullopt;
  return weights;
}

Target read_target(const TomlTable& table, const StudyContext& context) {
  Target target;
  target.place = table.place();
  // Known, though not here.
  for (const char* other : {"random", "file", "stimulus"}) table.text(other);
  const bool example = table.has("example");
  target.name = table.text("name").value_or("");
  target.weights = read_example(table, context);
  const auto blend = read_weights(table, context);
  if (blend) target.weights = blend;
  if (target.name.empty() && example) target.name = table.text("example").value_or("");
  refuse_unsafe_name(table, table.has("name") ? "name" : "example", target.name);
  if (target.name.empty() && table.has("weights")) {
    table.error(R"(a target of "weights" needs a "name")");
  }
  return target;
}

// One entry of the list: one target, or several.
std::vector<Target> read_source(const TomlTable& table, std::string_view key,
                                const StudyContext& context, const TargetRules& rules) {
  int sources = 0;
  for (const char* source : {"example", "weights", "random", "file", "all", "stimulus"}) {
    sources += table.has(source) ? 1 : 0;
  }
  if (sources != 1) {
    table.error(R"(a target needs one of "example", "weights", "random", "file", "all", )"
                R"("stimulus")");
  }
  if (table.has("stimulus") && !rules.stimuli) {
    table.error(
        "stimulus",
        "a stimulus is no mixture of the walks of the set, so that nobody can make it; name "
        "it in a task of kind \"rate\"");
  } else if (table.has("stimulus") && sources == 1) {
    return {read_stimulus_target(table, context)};
  }
  if (table.has("all")) return read_all_examples(table, context);
  if (table.has("random")) return read_random_targets(table, key, context, rules);
  if (table.has("file")) return read_target_file(table, context);
  return {read_target(table, context)};
}

// By their places: an entry may stand for several.
void refuse_double_targets(TomlReader& reader, const std::vector<Target>& targets) {
  std::set<std::string> names;
  for (const Target& target : targets) {
    if (target.name.empty() || names.insert(target.name).second || !reader.whole()) continue;
    reader.add(target.place,
               "there is another target with the name \"" + target.name + "\" before");
  }
}

// Does `text` say `word`, as a word of its own? Letters beyond ASCII (Japanese) need
// no gap between words.
bool says(const std::string& text, const std::string& word) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (word.empty()) return false;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_letter(text[at - 1]);
    const bool ends = end == text.size() || !is_letter(text[end]);
    if (begins && ends) return true;
  }
  return false;
}

// A list of labels that has the asked word in it answers the task for the person.
void warn_of_labels(const TomlTable& table, const Target& target, const StudyContext& context) {
  if (!context.space) return;
  for (const auto& [language, quality] : target.quality) {
    const Texts texts = texts_in(context.texts, language);
    for (const motion::Cycle& cycle : context.space->set.cycles) {
      const std::string label = texts.style(cycle.style);
      if (!says(label, quality) && !says(quality, label) && !says(cycle.name, quality)) continue;
      table.warning("", fmt::format("the asked quality \"{}\" is also the name of the walk \"{}\"; "
                                    "an interface that shows names gives the answer away",
                                    quality, cycle.name));
    }
  }
}

// Those that the raters of the study were asked; else those of the source.
std::vector<std::string> known_pairs(const StudyContext& context) {
  const bool rated = !context.study.ratings_file.empty() && context.adjectives;
  const auto model = rated ? context.adjectives() : nullptr;
  if (model) return model->table.pairs;
  std::vector<std::string> pairs;
  for (const motion::AdjectivePair& pair : motion::adjective_pairs) {
    pairs.push_back(motion::pair_name(pair));
  }
  return pairs;
}

// pair = "sad-happy": what the raters say about it scores the asked word, which is the second.
std::string read_pair(const TomlTable& table, const StudyContext& context) {
  const auto pair = table.text("pair");
  if (!pair) return "";
  const std::vector<std::string> known = known_pairs(context);
  const motion::PairWords words = motion::words_of_pair(*pair);
  const std::string turned = std::string(words.right) + "-" + std::string(words.left);
  for (const std::string& one : {*pair, turned}) {
    if (std::find(known.begin(), known.end(), one) != known.end()) return *pair;
  }
  table.error("pair", "nobody rates the pair of adjectives \"" + *pair + "\"" +
                          did_you_mean(*pair, known) +
                          "; write the asked word second, as in \"sad-happy\"");
  return "";
}

std::vector<std::string> names_of(const std::vector<Target>& targets) {
  std::vector<std::string> names;
  names.reserve(targets.size());
  for (const Target& target : targets) names.push_back(target.name);
  return names;
}

}  // namespace

std::vector<Target> read_targets(const TomlTable& task, std::string_view key,
                                 const StudyContext& context, const TargetRules& rules) {
  std::vector<Target> targets;
  const std::vector<TomlTable> tables = task.tables(key);
  for (const TomlTable& table : tables) {
    for (Target& target : read_source(table, key, context, rules)) {
      targets.push_back(std::move(target));
    }
  }
  refuse_double_targets(task.reader(), targets);
  if (tables.empty() && key == "targets" && task.is(key, TomlValue::Kind::array)) {
    task.error(key, "\"targets\" must not be empty");
  }
  return targets;
}

std::vector<Target> read_qualities(const TomlTable& task, std::string_view key,
                                   const StudyContext& context) {
  std::vector<Target> targets;
  const std::vector<TomlTable> tables = task.tables(key);
  for (const TomlTable& table : tables) {
    Target target;
    target.name = read_name(table);
    target.pair = read_pair(table, context);
    target.quality = read_languages(table, target.name, context.study);
    warn_of_labels(table, target, context);
    targets.push_back(std::move(target));
  }
  refuse_doubles(tables, names_of(targets), "quality");
  if (targets.empty() && key == "qualities" && task.is(key, TomlValue::Kind::array)) {
    task.error(key, "\"qualities\" must not be empty");
  }
  return targets;
}

}  // namespace promenade::study
