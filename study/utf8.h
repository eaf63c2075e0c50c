// Characters of UTF-8, as far as what people type and messages count them.
#pragma once

#include <string>
#include <string_view>

namespace promenade::study {

// A byte 10xxxxxx begins none.
inline bool begins_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

// How many there are.
inline int count_characters(std::string_view text) {
  int count = 0;
  for (const char byte : text) count += begins_character(byte) ? 1 : 0;
  return count;
}

// The beginning of a text, up to `most` characters.
inline std::string_view first_characters(std::string_view text, int most) {
  std::size_t end = 0;
  for (int count = 0; end < text.size(); ++end) {
    if (begins_character(text[end]) && ++count > most) break;
  }
  return text.substr(0, end);
}

// The first character, and how many bytes it has; code 0 for what lies beyond the basic
// plane.
struct Character {
  unsigned int code = 0;
  std::size_t bytes = 1;
};

inline Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned int lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  if (lead < 0xE0) return {(lead & 0x1FU) << 6U | (byte(1) & 0x3FU), 2};
  if (lead >= 0xF0) return {0, 4};
  return {(lead & 0x0FU) << 12U | (byte(1) & 0x3FU) << 6U | (byte(2) & 0x3FU), 3};
}

// `code`: of the basic plane, as Dear ImGui hands characters on.
inline void append_character(std::string& text, unsigned int code) {
  const auto add = [&text](unsigned int byte) { text += static_cast<char>(byte); };
  if (code < 0x80) return add(code);
  if (code < 0x800) {
    add(0xC0 | code >> 6);
  } else {
    add(0xE0 | code >> 12);
    add(0x80 | (code >> 6 & 0x3F));
  }
  add(0x80 | (code & 0x3F));
}

// Takes the first character away; its code, 0 when there is none.
inline int take_character(std::string& text) {
  if (text.empty()) return 0;
  const auto first = static_cast<unsigned char>(text[0]);
  const int more = first < 0x80 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
  int code = more == 0 ? first : first & (0x3F >> more);
  std::size_t length = 1;
  for (; length < text.size() && !begins_character(text[length]); ++length) {
    code = code << 6 | (static_cast<unsigned char>(text[length]) & 0x3F);
  }
  text.erase(0, length);
  return code;
}

inline void drop_last_character(std::string& text) {
  while (!text.empty()) {
    const bool begins = begins_character(text.back());
    text.pop_back();
    if (begins) return;
  }
}

}  // namespace promenade::study
