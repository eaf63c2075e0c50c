#include "study/toml_parse.h"

#include <toml++/toml.h>

#include <algorithm>

#include "study/toml_limits.h"

namespace promenade::study {
namespace {

TomlPlace place_of(const toml::source_region& source) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

bool earlier(TomlPlace a, TomlPlace b) {
  return a.line != b.line ? a.line < b.line : a.column < b.column;
}

TomlValue value_of(const toml::node& node);

TomlValue table_of(const toml::table& table) {
  TomlValue value;
  for (const auto& [key, node] : table) {
    value.entries.push_back({std::string(key.str()), place_of(key.source()), value_of(node)});
  }
  // toml++ sorts by name.
  std::stable_sort(value.entries.begin(), value.entries.end(),
                   [](const TomlValue::Entry& a, const TomlValue::Entry& b) {
                     return earlier(a.place, b.place);
                   });
  return value;
}

TomlValue array_of(const toml::array& array) {
  TomlValue value;
  value.kind = TomlValue::Kind::array;
  for (const toml::node& node : array) value.elements.push_back(value_of(node));
  return value;
}

TomlValue scalar_of(const toml::node& node) {
  using Kind = TomlValue::Kind;
  TomlValue value;
  value.kind = Kind::date;
  if (const auto* text = node.as_string()) {
    value.kind = Kind::text;
    value.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.kind = Kind::integer;
    value.integer = integer->get();
    value.number = static_cast<double>(value.integer);
  } else if (const auto* number = node.as_floating_point()) {
    value.kind = Kind::number;
    value.number = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.kind = Kind::boolean;
    value.truth = boolean->get();
  }
  return value;
}

TomlValue value_of(const toml::node& node) {
  TomlValue value;
  if (const auto* table = node.as_table()) {
    value = table_of(*table);
  } else if (const auto* array = node.as_array()) {
    value = array_of(*array);
  } else {
    value = scalar_of(node);
  }
  value.place = place_of(node.source());
  return value;
}

}  // namespace

TomlValue parse_toml(const std::string& file, std::string_view text) {
  refuse_deep_toml(file, text);
  try {
    return value_of(toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    const TomlPlace place = place_of(error.source());
    throw InputError({{file,
                       place.line,
                       place.column,
                       "not valid TOML: " + std::string(error.description()),
                       {}}});
  }
}

}  // namespace promenade::study
