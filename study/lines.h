// A text as its lines, without their ends; no line for nothing. A ranking is stored so: the
// names in order, one a line.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace promenade::study {

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

}  // namespace promenade::study
