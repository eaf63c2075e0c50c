#include "study/toml_text.h"

#include <fmt/format.h>

#include <cmath>

#include "study/toml_path.h"

namespace promenade::study {
namespace {

using Kind = TomlValue::Kind;

TomlValue of_kind(Kind kind) {
  TomlValue value;
  value.kind = kind;
  return value;
}

bool is_control(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte < 0x20 || byte == 0x7F;
}

std::string escaped(char letter) {
  if (letter == '"') return "\\\"";
  if (letter == '\\') return "\\\\";
  if (letter == '\n') return "\\n";
  if (letter == '\t') return "\\t";
  if (letter == '\r') return "\\r";
  if (is_control(letter)) return fmt::format("\\u{:04X}", static_cast<unsigned char>(letter));
  return {letter};
}

// With a point, so that it is read as a number and no whole one.
std::string written_number(double number) {
  if (std::isnan(number)) return "nan";
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", number);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string written_array(const TomlValue& value) {
  std::string text;
  for (const TomlValue& element : value.elements) {
    text += (text.empty() ? "" : ", ") + written_value(element);
  }
  return "[" + text + "]";
}

std::string written_table(const TomlValue& value) {
  std::string text;
  for (const TomlValue::Entry& entry : value.entries) {
    text +=
        (text.empty() ? "" : ", ") + written_key(entry.key) + " = " + written_value(entry.value);
  }
  return text.empty() ? "{}" : "{ " + text + " }";
}

bool same_number(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same_tables(const TomlValue& a, const TomlValue& b) {
  if (a.entries.size() != b.entries.size()) return false;
  for (const TomlValue::Entry& entry : a.entries) {
    const TomlValue* other = find_key(b, entry.key);
    if (other == nullptr || !same_toml(entry.value, *other)) return false;
  }
  return true;
}

bool same_arrays(const TomlValue& a, const TomlValue& b) {
  if (a.elements.size() != b.elements.size()) return false;
  for (std::size_t i = 0; i < a.elements.size(); ++i) {
    if (!same_toml(a.elements[i], b.elements[i])) return false;
  }
  return true;
}

}  // namespace

std::string toml_quoted(std::string_view text) {
  std::string written = "\"";
  for (const char letter : text) written += escaped(letter);
  return written + '"';
}

TomlValue toml_text(std::string_view text) {
  TomlValue value = of_kind(Kind::text);
  value.text = text;
  return value;
}

TomlValue toml_integer(std::int64_t integer) {
  TomlValue value = of_kind(Kind::integer);
  value.integer = integer;
  value.number = static_cast<double>(integer);
  return value;
}

TomlValue toml_number(double number) {
  constexpr double largest_whole = 1e15;
  if (number == std::floor(number) && std::abs(number) < largest_whole) {
    return toml_integer(static_cast<std::int64_t>(number));
  }
  TomlValue value = of_kind(Kind::number);
  value.number = number;
  return value;
}

TomlValue toml_boolean(bool truth) {
  TomlValue value = of_kind(Kind::boolean);
  value.truth = truth;
  return value;
}

TomlValue toml_array(std::vector<TomlValue> elements) {
  TomlValue value = of_kind(Kind::array);
  value.elements = std::move(elements);
  return value;
}

TomlValue toml_texts(const std::vector<std::string>& texts) {
  TomlValue value = of_kind(Kind::array);
  for (const std::string& text : texts) value.elements.push_back(toml_text(text));
  return value;
}

TomlValue toml_table(const std::vector<std::pair<std::string, TomlValue>>& entries) {
  TomlValue value = of_kind(Kind::table);
  for (const auto& [key, entry] : entries) value.entries.push_back({key, {}, entry});
  return value;
}

std::string written_key(std::string_view key) {
  return is_bare_key(key) ? std::string(key) : toml_quoted(key);
}

std::string written_value(const TomlValue& value) {
  switch (value.kind) {
    case Kind::table:
      return written_table(value);
    case Kind::array:
      return written_array(value);
    case Kind::text:
      return toml_quoted(value.text);
    case Kind::integer:
      return std::to_string(value.integer);
    case Kind::number:
      return written_number(value.number);
    case Kind::boolean:
      return value.truth ? "true" : "false";
    case Kind::date:
      break;  // no editor writes one
  }
  return "";
}

std::string written_lines(std::string_view text, std::string_view line_end) {
  std::string written = R"(""")" + std::string(line_end);
  for (const char letter : text) {
    written += letter == '\n' ? std::string(line_end) : escaped(letter);
  }
  return written + R"(""")";
}

bool same_toml(const TomlValue& a, const TomlValue& b) {
  if (a.kind != b.kind) return false;
  switch (a.kind) {
    case Kind::table:
      return same_tables(a, b);
    case Kind::array:
      return same_arrays(a, b);
    case Kind::text:
      return a.text == b.text;
    case Kind::integer:
      return a.integer == b.integer;
    case Kind::number:
      return same_number(a.number, b.number);
    case Kind::boolean:
      return a.truth == b.truth;
    case Kind::date:
      return true;  // an edit leaves its bytes alone
  }
  return false;
}

const TomlValue* find_key(const TomlValue& table, std::string_view key) {
  for (const TomlValue::Entry& entry : table.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

}  // namespace promenade::study
