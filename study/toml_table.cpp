#include <fmt/format.h>

#include "motion/did_you_mean.h"
#include "study/toml_reader.h"

namespace promenade::study {
namespace {

using Kind = TomlValue::Kind;

bool is_number(const TomlValue& value) {
  return value.kind == Kind::integer || value.kind == Kind::number;
}

std::string wrong_kind(std::string_view key, const char* wanted, Kind found) {
  return fmt::format("\"{}\" must be {}, but is {}", key, wanted, kind_name(found));
}

}  // namespace

const TomlValue* TomlTable::find(std::string_view key) const {
  for (const TomlValue::Entry& entry : value_->entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

const TomlValue* TomlTable::ask(std::string_view key) const {
  reader_->asked_[value_].emplace(key);
  return find(key);
}

const TomlValue* TomlTable::ask(std::string_view key, Kind kind, const char* wanted) const {
  const TomlValue* value = ask(key);
  if (!value || value->kind == kind) return value;
  reader_->add(value->place, wrong_kind(key, wanted, value->kind));
  return nullptr;
}

Place TomlTable::place(std::string_view key) const {
  const TomlValue* value = find(key);
  return value ? value->place : place();
}

bool TomlTable::has(std::string_view key) const { return find(key) != nullptr; }

bool TomlTable::is(std::string_view key, Kind kind) const {
  const TomlValue* value = find(key);
  return value && value->kind == kind;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> keys;
  for (const TomlValue::Entry& entry : value_->entries) keys.push_back(entry.key);
  return keys;
}

std::optional<std::string> TomlTable::text(std::string_view key) const {
  const TomlValue* value = ask(key, Kind::text, "a text in quotes");
  return value ? std::optional(value->text) : std::nullopt;
}

std::string TomlTable::required_text(std::string_view key) const {
  require(key);
  const std::optional<std::string> found = text(key);
  if (found && found->empty()) error(key, fmt::format("\"{}\" must not be empty", key));
  return found.value_or("");
}

std::optional<std::string> TomlTable::choice(std::string_view key,
                                             const std::vector<std::string>& choices) const {
  std::optional<std::string> found = text(key);
  if (!found) return std::nullopt;
  for (const std::string& choice : choices) {
    if (choice == *found) return found;
  }
  const std::string meant = did_you_mean(*found, choices);
  error(key, fmt::format(R"("{}" is "{}", but must be one of {}{})", key, *found,
                         quoted_list(choices), meant));
  return std::nullopt;
}

std::optional<double> TomlTable::number(std::string_view key, double least, double most) const {
  const TomlValue* value = ask(key);
  if (!value) return std::nullopt;
  if (!is_number(*value)) {
    reader_->add(value->place, wrong_kind(key, "a number", value->kind));
    return std::nullopt;
  }
  if (value->number >= least && value->number <= most) return value->number;
  reader_->add(value->place, fmt::format("\"{}\" is {}, but must be from {} to {}", key,
                                         value->number, least, most));
  return std::nullopt;
}

std::optional<std::int64_t> TomlTable::integer(std::string_view key, std::int64_t least,
                                               std::int64_t most) const {
  const TomlValue* value = ask(key, Kind::integer, "a whole number");
  if (!value) return std::nullopt;
  if (value->integer >= least && value->integer <= most) return value->integer;
  reader_->add(value->place, fmt::format("\"{}\" is {}, but must be from {} to {}", key,
                                         value->integer, least, most));
  return std::nullopt;
}

std::optional<bool> TomlTable::boolean(std::string_view key) const {
  const TomlValue* value = ask(key, Kind::boolean, "true or false");
  return value ? std::optional(value->truth) : std::nullopt;
}

std::optional<TomlScalar> TomlTable::scalar(std::string_view key) const {
  const TomlValue* value = ask(key);
  if (!value) return std::nullopt;
  if (is_number(*value)) return value->number;
  if (value->kind == Kind::boolean) return value->truth;
  if (value->kind == Kind::text) return value->text;
  reader_->add(value->place, wrong_kind(key, "a text, a number, true or false", value->kind));
  return std::nullopt;
}

std::optional<TomlTable> TomlTable::table(std::string_view key) const {
  const TomlValue* value = ask(key, Kind::table, "a table");
  return value ? std::optional(TomlTable(*reader_, *value)) : std::nullopt;
}

template <class Element, class Take>
std::vector<Element> TomlTable::list(std::string_view key, const char* wanted, Take take) const {
  std::vector<Element> elements;
  const TomlValue* found = ask(key, Kind::array, wanted);
  if (!found) return elements;
  for (const TomlValue& element : found->elements) {
    if (std::optional<Element> one = take(element)) {
      elements.push_back(std::move(*one));
    } else {
      reader_->add(element.place, wrong_kind(key, wanted, element.kind) + " here");
    }
  }
  return elements;
}

std::vector<TomlText> TomlTable::texts(std::string_view key) const {
  return list<TomlText>(key, "a list of texts", [](const TomlValue& element) {
    return element.kind == Kind::text ? std::optional(TomlText{element.text, element.place})
                                      : std::nullopt;
  });
}

std::vector<double> TomlTable::numbers(std::string_view key) const {
  return list<double>(key, "a list of numbers", [](const TomlValue& element) {
    return is_number(element) ? std::optional(element.number) : std::nullopt;
  });
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  return list<TomlTable>(key, "a list of tables", [this](const TomlValue& element) {
    return element.kind == Kind::table ? std::optional(TomlTable(*reader_, element)) : std::nullopt;
  });
}

void TomlTable::require(std::string_view key) const {
  if (!has(key)) error(fmt::format("\"{}\" is missing here", key));
}

void TomlTable::error(std::string_view key, const std::string& message) const {
  reader_->add(place(key), message);
}

void TomlTable::error(const std::string& message) const {
  if (reader_->whole()) reader_->add(place(), message);
}

void TomlTable::warning(std::string_view key, const std::string& message) const {
  reader_->add(place(key), message, Severity::warning);
}

}  // namespace promenade::study
