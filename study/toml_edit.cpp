#include "study/toml_edit.h"

#include <algorithm>

#include "motion/problem.h"
#include "study/toml_parse.h"
#include "study/toml_surgery.h"

namespace promenade::study {
namespace {

using Kind = TomlValue::Kind;

TomlValue* find(TomlValue& value, const TomlStep& step) {
  if (const auto* place = std::get_if<std::size_t>(&step)) {
    return *place < value.elements.size() ? &value.elements[*place] : nullptr;
  }
  return const_cast<TomlValue*>(find_key(value, std::get<std::string>(step)));
}

TomlValue* find(TomlValue& root, const TomlPath& path) {
  TomlValue* value = &root;
  for (const TomlStep& step : path) {
    value = find(*value, step);
    if (value == nullptr) return nullptr;
  }
  return value;
}

// With the tables that lead there.
bool set(TomlValue& root, const TomlPath& path, const TomlValue& wanted) {
  TomlValue* value = &root;
  for (const TomlStep& step : path) {
    TomlValue* inner = find(*value, step);
    if (inner == nullptr) {
      const auto* key = std::get_if<std::string>(&step);
      if (key == nullptr || value->kind != Kind::table) return false;
      value->entries.push_back({*key, {}, {}});
      inner = &value->entries.back().value;
    }
    value = inner;
  }
  *value = wanted;
  return true;
}

bool remove(TomlValue& root, const TomlPath& path) {
  if (path.empty()) return false;
  TomlValue* parent = find(root, parent_of(path));
  if (parent == nullptr || find(*parent, path.back()) == nullptr) return false;
  if (const auto* place = std::get_if<std::size_t>(&path.back())) {
    parent->elements.erase(parent->elements.begin() + static_cast<std::ptrdiff_t>(*place));
  } else {
    std::erase_if(parent->entries, [&](const TomlValue::Entry& entry) {
      return entry.key == std::get<std::string>(path.back());
    });
  }
  return true;
}

bool insert(TomlValue& root, const TomlEdit& edit) {
  TomlValue* list = find(root, edit.path);
  if (list == nullptr) return edit.at == 0 && set(root, edit.path, toml_array({edit.value}));
  if (list->kind != Kind::array || edit.at > list->elements.size()) return false;
  list->elements.insert(list->elements.begin() + static_cast<std::ptrdiff_t>(edit.at), edit.value);
  return true;
}

bool move(TomlValue& root, const TomlEdit& edit) {
  TomlValue* list = find(root, edit.path);
  if (list == nullptr || std::max(edit.at, edit.to) >= list->elements.size()) return false;
  TomlValue element = std::move(list->elements[edit.at]);
  list->elements.erase(list->elements.begin() + static_cast<std::ptrdiff_t>(edit.at));
  list->elements.insert(list->elements.begin() + static_cast<std::ptrdiff_t>(edit.to),
                        std::move(element));
  return true;
}

// What the text must say after the edit. A list of [[blocks]] is gone with its last one.
TomlValue expected(const std::string& file, const TomlSurgery& surgery, TomlValue root,
                   const TomlEdit& edit) {
  if (!apply_edit(root, edit)) {
    throw InputError(file, "there is no \"" + to_text(edit.path) + "\" in the file");
  }
  if (edit.kind == TomlEdit::Kind::remove && !last_key(edit.path).empty()) return root;
  if (edit.kind != TomlEdit::Kind::remove) return root;
  const TomlPath list = parent_of(edit.path);
  const TomlValue* left = value_at(root, list);
  if (left->elements.empty() && surgery.has_blocks(list)) remove(root, list);
  return root;
}

// Is `text` what the edit asks for?
bool says(const std::string& file, const std::string& text, const TomlValue& wanted) {
  try {
    return same_toml(parse_toml(file, text), wanted);
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

TomlEdit set_value(TomlPath path, TomlValue value) {
  return {TomlEdit::Kind::set, std::move(path), std::move(value)};
}

TomlEdit remove_value(TomlPath path) { return {TomlEdit::Kind::remove, std::move(path), {}}; }

TomlEdit insert_value(TomlPath list, std::size_t at, TomlValue value) {
  return {TomlEdit::Kind::insert, std::move(list), std::move(value), at};
}

TomlEdit move_value(TomlPath list, std::size_t from, std::size_t to) {
  return {TomlEdit::Kind::move, std::move(list), {}, from, to};
}

std::string edited_toml(const std::string& file, const std::string& text, const TomlEdit& edit) {
  const TomlValue before = parse_toml(file, text);
  TomlSurgery surgery(file, text);
  const TomlValue wanted = expected(file, surgery, before, edit);
  if (same_toml(before, wanted)) return text;
  std::string result = surgery.edited(edit);
  if (!says(file, result, wanted)) {
    throw InputError(file, "\"" + to_text(edit.path) +
                               "\" cannot be changed here without changing something else; change "
                               "it in the file itself");
  }
  return result;
}

bool apply_edit(TomlValue& root, const TomlEdit& edit) {
  switch (edit.kind) {
    case TomlEdit::Kind::set:
      return !edit.path.empty() && set(root, edit.path, edit.value);
    case TomlEdit::Kind::remove:
      return remove(root, edit.path);
    case TomlEdit::Kind::insert:
      return insert(root, edit);
    case TomlEdit::Kind::move:
      return move(root, edit);
  }
  return false;
}

const TomlValue* value_at(const TomlValue& root, const TomlPath& path) {
  return find(const_cast<TomlValue&>(root), path);
}

}  // namespace promenade::study
