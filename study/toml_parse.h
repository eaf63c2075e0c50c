// TOML text to plain values; the only place that knows toml++.
#pragma once

#include "study/toml_reader.h"

namespace promenade::study {

// The root table. Throws InputError with one problem when the text is no TOML.
TomlValue parse_toml(const std::string& file, std::string_view text);

}  // namespace promenade::study
