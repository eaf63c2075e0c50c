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
      for (const std::string& name : names_in(task, list_key, {"name", "example", "stimulus"})) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      }
    }
  }
  return names;
}

std::string text_in(const TomlValue& table, std::string_view key, std::string_view otherwise) {
  const TomlValue* value = find(table, key);
  return std::string(value && value->kind == TomlValue::Kind::text ? value->text : otherwise);
}

std::vector<std::string> guesses_in(const TomlValue& root) {
  std::vector<std::string> names;
  const TomlValue* tasks = find(root, "task");
  if (!tasks) return names;
  for (const TomlValue& task : tasks->elements) {
    if (text_in(task, "kind", "") == "guess") names.push_back(text_in(task, "name", ""));
  }
  return names;
}

std::string order_in(const TomlValue& root) {
  const TomlValue* study = find(root, "study");
  return study ? text_in(*study, "order", "williams") : "";
}

std::string published_in(const TomlValue& root) {
  const TomlValue* study = find(root, "study");
  return study ? text_in(*study, "published", "") : "";
}

std::vector<OutlinedDraw> draws_in(const TomlValue& root) {
  std::vector<OutlinedDraw> draws;
  const TomlValue* tasks = find(root, "task");
  if (!tasks) return draws;
  for (const TomlValue& task : tasks->elements) {
    const TomlValue* targets = find(task, "targets");
    if (!targets || text_in(task, "kind", "") == "rate") continue;
    for (const TomlValue& target : targets->elements) {
      const OutlinedDraw draw{text_in(task, "name", ""), text_in(target, "random", "")};
      const bool known = std::any_of(draws.begin(), draws.end(), [&](const OutlinedDraw& other) {
        return other.task == draw.task && other.model == draw.model;
      });
      if (!draw.model.empty() && !known) draws.push_back(draw);
    }
  }
  return draws;
}

}  // namespace

Outline outline_of(std::string_view config_text) {
  try {
    const TomlValue root = parse_toml("", config_text);
    return {names_in(root, "interface", {"name", "type"}),
            names_in(root, "task", {"name"}),
            targets_in(root),
            names_in(root, "rating", {"item"}),
            guesses_in(root),
            order_in(root),
            names_in(root, "interface", {"type", "name"}),
            published_in(root),
            draws_in(root),
            names_in(root, "stimulus", {"name"})};
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace promenade::study
