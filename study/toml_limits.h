// What the parser of TOML must not be asked: it recurses over the parts of a key
// and over nested values, without a limit of its own for the former.
#pragma once

#include <string>
#include <string_view>

namespace promenade::study {

// Throws InputError, with line and column, at the first key of more than 32 parts and
// at the first value that is nested more than 64 deep. Knows strings and comments;
// whatever else is wrong in the text is left to the parser.
void refuse_deep_toml(const std::string& file, std::string_view text);

}  // namespace promenade::study
