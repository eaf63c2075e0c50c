// Targets that stand in a file: { file = ... }, and the draw that { random = ..., kept_in = ... }
// keeps there.
#include <fmt/format.h>

#include "study/study_parts.h"
#include "study/targets_csv.h"

namespace promenade::study {
namespace {

std::vector<Target> targets_in(const std::string& name, const TomlTable& table,
                               std::string_view key, const StudyContext& context) {
  std::vector<Target> targets =
      read_targets_csv(context.files.full_path(name), context.files.read(name),
                       motion::names_of(context.space->set));
  for (Target& target : targets) {
    target.place = table.place();
    refuse_unsafe_name(table, key, target.name);
  }
  return targets;
}

}  // namespace

std::vector<Target> read_target_file(const TomlTable& table, const StudyContext& context) {
  const auto name = table.text("file");
  if (!name || !context.space) return {};
  try {
    return targets_in(*name, table, "file", context);
  } catch (const InputError& error) {
    add_file_problems(table, "file", "the targets \"" + *name + "\"", error);
    return {};
  }
}

std::optional<std::vector<Target>> read_kept_targets(const TomlTable& table, int count, bool each,
                                                     const StudyContext& context) {
  const auto name = table.text("kept_in");
  if (!name) return std::nullopt;
  if (each) {
    table.error("kept_in", "what is drawn for each participant cannot be kept in one file");
    return std::nullopt;
  }
  try {
    const std::vector<std::string> motions = motion::names_of(context.space->set);
    if (!is_about_motions(context.files.read(*name), motions)) {
      table.warning("kept_in", "the targets in \"" + *name +
                                   "\" are mixtures of other motions than those of this set, so "
                                   "that they are drawn anew");
      return std::nullopt;
    }
    std::vector<Target> targets = targets_in(*name, table, "kept_in", context);
    if (static_cast<int>(targets.size()) != count) {
      table.error("kept_in", fmt::format("\"{}\" holds {} targets, but \"count\" is {}", *name,
                                         targets.size(), count));
    }
    return targets;
  } catch (const InputError& error) {
    add_file_problems(table, "kept_in", "the targets \"" + *name + "\"", error);
    return std::vector<Target>();
  }
}

}  // namespace promenade::study
