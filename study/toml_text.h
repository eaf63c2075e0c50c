// Values as they are written in a TOML file, and values to write.
#pragma once

#include <string>
#include <string_view>

#include "study/toml_reader.h"

namespace promenade::study {

TomlValue toml_text(std::string_view text);
TomlValue toml_integer(std::int64_t integer);
TomlValue toml_number(double number);  // a whole one becomes a whole number: 45, not 45.0
TomlValue toml_boolean(bool truth);
TomlValue toml_array(std::vector<TomlValue> elements);
TomlValue toml_texts(const std::vector<std::string>& texts);
TomlValue toml_table(const std::vector<std::pair<std::string, TomlValue>>& entries);

// A text in its quotes, on one line.
std::string toml_quoted(std::string_view text);
// A key, in quotes where it needs them.
std::string written_key(std::string_view key);
// On one line; tables as { a = 1 }.
std::string written_value(const TomlValue& value);
// A text over several lines, with these line ends.
std::string written_lines(std::string_view text, std::string_view line_end);

// The same content, wherever it stands: keys of a table in any order.
bool same_toml(const TomlValue& a, const TomlValue& b);

// The value that has this key; null: there is none.
const TomlValue* find_key(const TomlValue& table, std::string_view key);

}  // namespace promenade::study
