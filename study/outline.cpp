#include "study/outline.h"

#include <algorithm>

#include "study/toml_parse.h"

namespace promenade::study {
namespace {

const TomlValue* find(const TomlValue& table, std::string_view key) {
  for (const TomlValue::Entry& entry : table.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

// The text of the first key that an entry of the list has.
std::vector<std::string> names_in(const TomlValue& table, std::string_view list_key,
                                  const std::vector<std::string_view>& keys) {
  std::vector<std::string> names;
  const TomlValue* list = find(table, list_key);
  if (!list) return names;
  for (const TomlValue& entry : list->elements) {
    for (const std::string_view key : keys) {
      const TomlValue* name = find(entry, key);
      if (!name || name->kind != TomlValue::Kind::text) continue;
      names.push_back(name->text);
      break;
    }
  }
  return names;
}

std::vector<std::string> targets_in(const TomlValue& root) {
  std::vector<std::string> names;
  const TomlValue* tasks = find(root, "task");
  if (!tasks) return names;
  for (const TomlValue& task : tasks->elements) {
    for (const std::string_view list_key : {"targets", "qualities"}) {
      for (const std::string& name : names_in(task, list_key, {"name", "example"})) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      }
    }
  }
  return names;
}

// Names of the tasks of kind guess.
std::vector<std::string> guesses_in(const TomlValue& root) {
  std::vector<std::string> names;
  const TomlValue* tasks = find(root, "task");
  if (!tasks) return names;
  for (const TomlValue& task : tasks->elements) {
    const TomlValue* kind = find(task, "kind");
    const TomlValue* name = find(task, "name");
    if (!kind || !name || kind->text != "guess") continue;
    if (name->kind == TomlValue::Kind::text) names.push_back(name->text);
  }
  return names;
}

}  // namespace

Outline outline_of(std::string_view config_text) {
  try {
    const TomlValue root = parse_toml("", config_text);
    return {names_in(root, "interface", {"name", "type"}), names_in(root, "task", {"name"}),
            targets_in(root), names_in(root, "rating", {"item"}), guesses_in(root)};
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace promenade::study
