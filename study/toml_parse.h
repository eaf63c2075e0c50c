// TOML text to plain values; the only place that knows toml++.
#pragma once

#include "study/toml_reader.h"

namespace promenade::study {

// The root table. Throws InputError with one problem when the text is no TOML.
TomlValue parse_toml(const std::string& file, std::string_view text);

// As much of a broken file as can be understood, so that what is wrong elsewhere in it is
// said in the same run: a line `key = value` that is no TOML is a problem and left out.
struct ParsedToml {
  TomlValue root;
  std::vector<Problem> problems;
  bool usable = true;  // false: the root is empty
};
ParsedToml parse_lines_of_toml(const std::string& file, std::string_view text);

}  // namespace promenade::study
