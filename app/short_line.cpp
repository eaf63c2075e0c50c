#include "app/short_line.h"

#include <algorithm>
#include <charconv>

namespace promenade::app {

ShortLine& ShortLine::add(std::string_view text) {
  const std::size_t room = std::min(text.size(), letters_.size() - length_);
  std::copy_n(text.begin(), room, letters_.begin() + static_cast<std::ptrdiff_t>(length_));
  length_ += room;
  return *this;
}

ShortLine& ShortLine::add(int number) {
  std::array<char, 12> digits{};
  const char* end = std::to_chars(digits.begin(), digits.end(), number).ptr;
  return add({digits.data(), static_cast<std::size_t>(end - digits.data())});
}

ShortLine with_number(std::string_view text, int number) {
  const std::size_t from = text.find('{');
  const std::size_t to = text.find('}');
  ShortLine line;
  if (from == std::string_view::npos || to == std::string_view::npos) return line.add(text);
  return line.add(text.substr(0, from)).add(number).add(text.substr(to + 1));
}

}  // namespace promenade::app
