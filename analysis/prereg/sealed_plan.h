// The plan out of the document that was registered: its last block holds PLAN.toml to the letter.
#pragma once

#include <string>
#include <string_view>

namespace promenade::analysis {

// A fence for a block of Markdown that nothing in the text can end: tildes.
std::string fence_for(std::string_view text);

// PLAN.toml, from Markdown or HTML that `promenade prereg` wrote. Throws InputError when there is
// none, or its hash is not the one that the document states.
std::string plan_text_in(const std::string& file, std::string_view document);

}  // namespace promenade::analysis
