#include "app/line_breaks.h"

namespace promenade::app {
namespace {

std::size_t character_length(std::string_view text, std::size_t at) {
  const auto byte = static_cast<unsigned char>(text[at]);
  const std::size_t length = byte < 0x80 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
  return std::min(length, text.size() - at);
}

bool is_wide(std::string_view character) { return character.size() >= 3 && character[0] != '\xE2'; }

bool is_one_of(std::string_view set, std::string_view character) {
  const std::size_t at = character.size() == 3 ? set.find(character) : std::string_view::npos;
  return at != std::string_view::npos && at % 3 == 0;  // each has three bytes
}

// Characters that no line begins with, and those that none ends with.
bool closes(std::string_view character) {
  return is_one_of("、。）」』！？：・ーゃゅょっャュョッ", character);
}
bool opens(std::string_view character) { return is_one_of("（「『", character); }

// The first place after `from` where a line may end.
std::size_t next_break(std::string_view text, std::size_t from) {
  std::size_t at = from;
  while (at < text.size()) {
    const std::string_view character = text.substr(at, character_length(text, at));
    at += character.size();
    if (at >= text.size() || text[at] == ' ' || text[at] == '\n') return at;
    const std::string_view next = text.substr(at, character_length(text, at));
    if (!is_wide(character) && !is_wide(next)) continue;
    if (!closes(next) && !opens(character)) return at;
  }
  return text.size();
}

}  // namespace

std::size_t first_line(std::string_view text, float width,
                       const std::function<float(std::string_view)>& measure) {
  std::size_t end = 0;
  while (end < text.size() && text[end] != '\n') {
    const std::size_t next = next_break(text, end);
    if (end > 0 && measure(text.substr(0, next)) > width) break;
    end = next;
  }
  return end;
}

std::vector<std::string_view> break_lines(std::string_view text, float width,
                                          const std::function<float(std::string_view)>& measure) {
  std::vector<std::string_view> lines;
  std::size_t start = 0;
  std::size_t end = 0;  // of the line so far
  while (start < text.size()) {
    if (text[end] == '\n') {
      lines.push_back(text.substr(start, end - start));
      start = ++end;
      continue;
    }
    const std::size_t next = next_break(text, end);
    if (end > start && measure(text.substr(start, next - start)) > width) {
      lines.push_back(text.substr(start, end - start));
      start = end + (text[end] == ' ' ? 1 : 0);
      end = start;
      continue;
    }
    end = next;
    if (end == text.size()) {
      lines.push_back(text.substr(start));
      break;
    }
  }
  return lines;
}

}  // namespace promenade::app
