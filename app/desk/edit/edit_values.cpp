#include "app/desk/edit/edit_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace promenade::app {
namespace {

using study::TomlPath;
using study::TomlValue;
using Kind = TomlValue::Kind;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

std::optional<double> number_in(std::string_view text) {
  text = trimmed(text);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole_text = error == std::errc() && end == text.data() + text.size();
  return whole_text && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

std::optional<TomlValue> number_value(const EditField& field, std::string_view text) {
  const auto number = number_in(text);
  if (!number || *number < field.least || *number > field.most) return std::nullopt;
  if (field.kind == FieldKind::whole && *number != std::floor(*number)) return std::nullopt;
  return study::toml_number(*number);
}

// "sad 0.5, old 0.5", and with an equals sign.
std::optional<TomlValue> shares_value(std::string_view text) {
  std::vector<std::pair<std::string, TomlValue>> entries;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    const std::string_view part = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t gap = part.find_last_of(" =");
    if (gap == part.npos) return std::nullopt;
    const auto share = number_in(part.substr(gap + 1));
    std::string_view name = trimmed(part.substr(0, gap));
    if (name.ends_with('=')) name = trimmed(name.substr(0, name.size() - 1));
    if (!share || name.empty()) return std::nullopt;
    entries.emplace_back(name, study::toml_number(*share));
  }
  return study::toml_table(entries);
}

TomlValue list_value(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string& word : split_choices(text)) words.push_back(word);
  return study::toml_texts(words);
}

std::optional<TomlValue> value_of(const EditField& field, const std::string& text) {
  switch (field.kind) {
    case FieldKind::number:
    case FieldKind::whole:
      return number_value(field, text);
    case FieldKind::auto_number:
      return trimmed(text) == "auto" ? study::toml_text("auto") : number_value(field, text);
    case FieldKind::flag:
      return study::toml_boolean(text == "true");
    case FieldKind::shares:
      return shares_value(text);
    case FieldKind::nesting: {
      std::string words = text;
      for (std::size_t at = words.find(", "); at != words.npos; at = words.find(", ")) {
        words.replace(at, 2, "|");
      }
      return list_value(words);
    }
    default:
      return study::toml_text(text);
  }
}

std::string shown_scalar(const TomlValue& value) {
  switch (value.kind) {
    case Kind::text:
      return value.text;
    case Kind::integer:
      return std::to_string(value.integer);
    case Kind::number:
      return fmt::format("{}", value.number);
    case Kind::boolean:
      return value.truth ? "true" : "false";
    default:
      return "";
  }
}

std::string joined_texts(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

}  // namespace

std::string shown_text(const TomlValue& root, const TomlPath& path, const EditField&) {
  const TomlValue* value = study::value_at(root, path);
  if (value == nullptr) return "";
  std::vector<std::string> parts;
  for (const TomlValue& element : value->elements) parts.push_back(shown_scalar(element));
  for (const TomlValue::Entry& entry : value->entries) {
    parts.push_back(entry.key + " " + shown_scalar(entry.value));
  }
  return parts.empty() ? shown_scalar(*value) : joined_texts(parts);
}

std::optional<Edits> edits_of_text(const TomlValue& root, const TomlPath& path,
                                   const EditField& field, const std::string& text) {
  if (text.empty() && !field.needed) {
    if (study::value_at(root, path) == nullptr) return Edits{};
    return Edits{study::remove_value(path)};
  }
  auto value = value_of(field, text);
  if (!value) return std::nullopt;
  return Edits{study::set_value(path, std::move(*value))};
}

std::string shown_words(const TomlValue& root, const TomlPath& path, const std::string& language) {
  const TomlValue* value = study::value_at(root, path);
  if (value == nullptr) return "";
  if (value->kind == Kind::text) return language == "en" ? value->text : "";
  const TomlValue* words = study::find_key(*value, language);
  return words != nullptr ? words->text : "";
}

Edits edits_of_words(const TomlValue& root, const TomlPath& path, bool spoken,
                     const std::string& language, const std::string& text) {
  const TomlValue* value = study::value_at(root, path);
  const TomlPath one = study::joined(path, language);
  if (spoken || (value != nullptr && value->kind == Kind::table)) {
    const bool there = study::value_at(root, one) != nullptr;
    if (!text.empty()) return {study::set_value(one, study::toml_text(text))};
    if (!there) return {};
    const bool last = !spoken && value->entries.size() == 1;
    return {study::remove_value(last ? path : one)};
  }
  if (text.empty()) {
    return value != nullptr && language == "en" ? Edits{study::remove_value(path)} : Edits{};
  }
  if (language == "en") return {study::set_value(path, study::toml_text(text))};
  std::vector<std::pair<std::string, TomlValue>> words;
  if (value != nullptr) words.emplace_back("en", study::toml_text(value->text));
  words.emplace_back(language, study::toml_text(text));
  return {study::set_value(path, study::toml_table(words))};
}

std::vector<std::string> shown_some(const TomlValue& root, const TomlPath& path,
                                    const std::vector<std::string>& standard) {
  const TomlValue* value = study::value_at(root, path);
  if (value == nullptr) return standard;
  std::vector<std::string> texts;
  for (const TomlValue& element : value->elements) texts.push_back(element.text);
  return texts;
}

Edits edits_of_some(const TomlValue& root, const TomlPath& path,
                    const std::vector<std::string>& standard, const std::string& one) {
  std::vector<std::string> now = shown_some(root, path, standard);
  const auto found = std::find(now.begin(), now.end(), one);
  const auto at = static_cast<std::size_t>(found - now.begin());
  if (study::value_at(root, path) != nullptr) {
    if (found != now.end()) return {study::remove_value(study::joined(path, at))};
    return {study::insert_value(path, now.size(), study::toml_text(one))};
  }
  if (found != now.end()) {
    now.erase(found);
  } else {
    now.push_back(one);
  }
  return {study::set_value(path, study::toml_texts(now))};
}

std::vector<std::string> nestings() {
  std::vector<std::string> order = {"interface", "target", "task"};
  std::vector<std::string> all;
  do {
    all.push_back(joined_texts(order));
  } while (std::next_permutation(order.begin(), order.end()));
  return all;
}

const std::vector<std::string>& target_sources() {
  static const std::vector<std::string> sources = {"example", "weights", "random",
                                                   "all",     "file",    "stimulus"};
  return sources;
}

std::string shown_source(const TomlValue& root, const TomlPath& path) {
  const TomlValue* table = study::value_at(root, path);
  if (table == nullptr) return "";
  for (const std::string& source : target_sources()) {
    if (study::find_key(*table, source) != nullptr) return source;
  }
  return "";
}

TomlValue new_target(const std::string& source, const std::string& walk,
                     const std::string& stimulus) {
  using study::toml_table;
  using study::toml_text;
  if (source == "weights") {
    return toml_table({{"name", toml_text("mixture")},
                       {"weights", toml_table({{walk, study::toml_integer(1)}})}});
  }
  if (source == "random") {
    return toml_table({{"random", toml_text("examples")}, {"count", study::toml_integer(1)}});
  }
  if (source == "all") return toml_table({{"all", study::toml_boolean(true)}});
  if (source == "file") return toml_table({{"file", toml_text("targets.csv")}});
  if (source == "stimulus") return toml_table({{"stimulus", toml_text(stimulus)}});
  return toml_table({{"example", toml_text(walk)}});
}

std::string title_of(const TomlValue& item) {
  for (const char* key :
       {"name", "item", "instrument", "example", "label", "random", "file", "stimulus"}) {
    const TomlValue* value = study::find_key(item, key);
    if (value != nullptr && !value->text.empty()) return value->text;
  }
  return study::find_key(item, "all") != nullptr ? "all" : "";
}

namespace {

bool is_title(const std::vector<TomlValue>& items, const std::string& title) {
  return std::any_of(items.begin(), items.end(),
                     [&](const TomlValue& item) { return title_of(item) == title; });
}

// "task 2", which none of the others is called.
std::string free_name(std::string_view name, const std::vector<TomlValue>& items) {
  std::size_t number = items.size() + 1;
  while (is_title(items, fmt::format("{} {}", name, number))) ++number;
  return fmt::format("{} {}", name, number);
}

// The first that no item has yet.
std::string free_choice(const std::vector<TomlValue>& items,
                        const std::vector<std::string>& choices) {
  for (const std::string& choice : choices) {
    if (!is_title(items, choice)) return choice;
  }
  return choices.empty() ? "" : choices.front();
}

}  // namespace

TomlValue new_item(std::string_view name, const std::vector<TomlValue>& items,
                   const std::vector<std::string>& choices) {
  using study::toml_array;
  using study::toml_table;
  using study::toml_text;
  const std::string choice = free_choice(items, choices);
  if (name == "target") return toml_table({{"example", toml_text(choice)}});
  if (name == "interface") {
    return is_title(items, choice) ? toml_table({{"name", toml_text(free_name(choice, items))},
                                                 {"type", toml_text(choice)}})
                                   : toml_table({{"name", toml_text(choice)}});
  }
  if (name == "questionnaire") {
    return toml_table({{"instrument", toml_text(choice)}, {"when", toml_text("end")}});
  }
  if (name == "part") {
    return toml_table({{"label", toml_text("label")}, {"seconds", study::toml_integer(4)}});
  }
  const std::string own = free_name(name, items);
  if (name == "task") {
    const TomlValue target = toml_table({{"example", toml_text(choice)}});
    return toml_table({{"name", toml_text(own)},
                       {"kind", toml_text("match")},
                       {"targets", toml_array({target})}});
  }
  if (name == "rating") {
    return toml_table(
        {{"item", toml_text(own)},
         {"question",
          toml_table({{"en", toml_text("How satisfied are you with this walk?")},
                      {"ja", toml_text("この歩き方にどのくらい満足していますか。")}})}});
  }
  if (name == "stimulus") {
    const TomlValue part =
        toml_table({{"label", toml_text("label")}, {"seconds", study::toml_integer(4)}});
    return toml_table({{"name", toml_text(own)},
                       {"graph", toml_text("walks.graph")},
                       {"parts", toml_array({part})}});
  }
  return toml_table({{"name", toml_text(own)}});
}

}  // namespace promenade::app
