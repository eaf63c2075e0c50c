// The page of the documentation that lists the interfaces, from their declarations.
#pragma once

#include <string>

#include "study/interface.h"
#include "study/texts.h"

namespace promenade::app {

// Markdown; titles and hints in the language of `texts`.
std::string interfaces_page(const study::InterfaceRegistry& registry, const study::Texts& texts);

}  // namespace promenade::app
