#include "study/toml_parse.h"

#include <toml++/toml.h>

#include <algorithm>

#include "study/toml_limits.h"

namespace promenade::study {
namespace {

Place place_of(const toml::source_region& source) {
  return {static_cast<int>(source.begin.line), static_cast<int>(source.begin.column)};
}

bool earlier(Place a, Place b) { return a.line != b.line ? a.line < b.line : a.column < b.column; }

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

Problem problem_of(const std::string& file, const toml::parse_error& error) {
  const Place place = place_of(error.source());
  return {file, place.line, place.column, "not valid TOML: " + std::string(error.description()),
          Severity::error};
}

// Is it `key = value`, the whole of it?
bool is_whole_entry(std::string_view line) {
  const std::size_t equals = line.find('=');
  const std::size_t first = line.find_first_not_of(" \t");
  if (equals == line.npos || first == equals) return false;
  for (const char c : line.substr(first, equals - first)) {
    const bool bare = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!bare && std::string_view("_-. \t").find(c) == std::string_view::npos) return false;
  }
  const auto count = [line](char c) { return std::count(line.begin(), line.end(), c); };
  return count('[') == count(']') && count('{') == count('}') && line.find(R"(""")") == line.npos &&
         line.find("'''") == line.npos;
}

// Blanks the line if it can be left out; everything else keeps its place.
bool leave_out(std::string& text, int line) {
  std::size_t begin = 0;
  for (int l = 1; l < line && begin != std::string::npos; ++l) {
    begin = text.find('\n', begin);
    if (begin != std::string::npos) ++begin;
  }
  if (begin == std::string::npos) return false;
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  if (!is_whole_entry(std::string_view(text).substr(begin, end - begin))) return false;
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(begin),
            text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
  return true;
}

}  // namespace

TomlValue parse_toml(const std::string& file, std::string_view text) {
  refuse_deep_toml(file, text);
  try {
    return value_of(toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    throw InputError({problem_of(file, error)});
  }
}

ParsedToml parse_lines_of_toml(const std::string& file, std::string_view text) {
  constexpr std::size_t most_problems = 20;
  ParsedToml parsed;
  try {
    refuse_deep_toml(file, text);
  } catch (const InputError& error) {
    return {{}, error.problems(), false};
  }
  std::string rest(text);
  while (parsed.problems.size() < most_problems) {
    try {
      parsed.root = value_of(toml::parse(rest, file));
      return parsed;
    } catch (const toml::parse_error& error) {
      parsed.problems.push_back(problem_of(file, error));
      if (!leave_out(rest, parsed.problems.back().line)) break;
    }
  }
  parsed.usable = false;
  return parsed;
}

}  // namespace promenade::study
