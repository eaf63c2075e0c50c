#include "app/participant_code.h"

#include <nlohmann/json.hpp>

#include "study/utf8.h"

namespace promenade::app {
namespace {

bool is_utf8(std::string_view text) {
  try {
    (void)nlohmann::json(text).dump();
    return true;
  } catch (const nlohmann::json::exception&) {
    return false;
  }
}

// C0, DEL and C1 (U+0080 to U+009F), in valid UTF-8.
bool has_control_characters(std::string_view text) {
  unsigned char before = 0;
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte == 0x7F || (before == 0xC2 && byte < 0xA0)) return true;
    before = byte;
  }
  return false;
}

}  // namespace

std::string participant_code_problem(std::string_view code) {
  if (code.empty()) return "the code is empty; leave the option out and the first page asks";
  if (!is_utf8(code)) return "the code is not UTF-8";
  if (has_control_characters(code)) return "the code holds control characters";
  const int count = study::count_characters(code);
  if (count <= longest_participant_code) return "";
  return "the code has " + std::to_string(count) + " characters; it can have up to " +
         std::to_string(longest_participant_code);
}

}  // namespace promenade::app
