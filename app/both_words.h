// A pair of adjectives as people read it.
#pragma once

#include <string>

namespace promenade::app {

// "slow – fast" for "slow-fast"; a name without a hyphen stays.
inline std::string both_words(std::string pair) {
  const auto dash = pair.find('-');
  return dash == std::string::npos ? pair : pair.replace(dash, 1, " – ");
}

}  // namespace promenade::app
