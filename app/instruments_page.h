// The list of the page of the documentation about instruments, from their files.
#pragma once

#include <string>
#include <vector>

#include "study/instrument.h"

namespace promenade::app {

// The line of the page behind which the list begins; what stands before is written by hand.
inline constexpr const char* instruments_mark = "<!-- from here on made by tools/docs -->\n";

// Markdown; titles in English.
std::string instruments_list(const std::vector<study::Instrument>& instruments);

}  // namespace promenade::app
