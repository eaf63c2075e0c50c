// Values as TOML writes them.
#pragma once

#include <string>
#include <string_view>

namespace promenade::study {

// A basic string, with its quotes.
std::string toml_quoted(std::string_view text);

}  // namespace promenade::study
