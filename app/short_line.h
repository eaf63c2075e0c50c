// A short text put together in a frame, without memory of its own.
#pragma once

#include <array>
#include <string_view>

namespace promenade::app {

class ShortLine {
 public:
  ShortLine& add(std::string_view text);  // what has no room is left out
  ShortLine& add(int number);
  std::string_view text() const { return {letters_.data(), length_}; }

 private:
  std::array<char, 192> letters_{};
  std::size_t length_ = 0;
};

// "{count} walks" with what is in braces replaced.
ShortLine with_number(std::string_view text, int number);

}  // namespace promenade::app
