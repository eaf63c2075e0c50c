#include "app/list_groups.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "study/utf8.h"

namespace promenade::app {
namespace {

constexpr std::array<std::string_view, 7> separators = {" ", ",", "-", "_", "、", "・", "，"};

// How many bytes of separators the text begins with.
std::size_t separators_at(std::string_view text) {
  std::size_t length = 0;
  const auto begins = [&](std::string_view mark) {
    return text.substr(length, mark.size()) == mark;
  };
  for (auto found = separators.begin(); found != separators.end();) {
    found = std::find_if(separators.begin(), separators.end(), begins);
    if (found != separators.end()) length += found->size();
  }
  return length;
}

std::string stem_of(const std::string& style) {
  const std::size_t hyphen = style.rfind('-');
  return hyphen == std::string::npos || hyphen == 0 ? style : style.substr(0, hyphen);
}

const std::string& style_of(const motion::Cycle& cycle) {
  return cycle.style.empty() ? cycle.name : cycle.style;
}

char lower(char letter) {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

}  // namespace

std::vector<int> style_groups(const motion::MotionSet& set) {
  std::map<std::string, std::set<std::string>> by_stem;
  for (const motion::Cycle& cycle : set.cycles) {
    by_stem[stem_of(style_of(cycle))].insert(style_of(cycle));
  }
  std::map<std::string, int> numbers;
  std::vector<int> groups;
  for (const motion::Cycle& cycle : set.cycles) {
    const std::string& style = style_of(cycle);
    const bool shared = by_stem[stem_of(style)].size() > 1;
    const auto next = static_cast<int>(numbers.size());
    groups.push_back(numbers.try_emplace(shared ? stem_of(style) : style, next).first->second);
  }
  return groups;
}

Grouping grouping_of(std::string_view wanted, const std::vector<int>& groups) {
  if (wanted == "style") return Grouping::style;
  if (wanted == "alphabet") return Grouping::alphabet;
  if (wanted == "none") return Grouping::none;
  const std::size_t count = std::set<int>(groups.begin(), groups.end()).size();
  if (2 * count <= groups.size()) return Grouping::style;
  return groups.size() > 20 ? Grouping::alphabet : Grouping::none;
}

std::size_t shared_beginning(std::string_view name, std::size_t length, std::string_view other) {
  const auto ends_word = [](std::string_view text, std::size_t at) {
    return at == text.size() || separators_at(text.substr(at)) > 0;
  };
  for (std::size_t at = std::min(length, name.size()); at > 0; --at) {
    const bool hangs_over = separators_at(name.substr(at - 1, 1)) > 0;
    const bool shared = name.substr(0, at) == other.substr(0, at);
    if (shared && !hangs_over && ends_word(name, at) && ends_word(other, at)) return at;
  }
  return 0;
}

std::string_view after_heading(std::string_view name, std::size_t heading) {
  const std::string_view rest = name.substr(std::min(heading, name.size()));
  const std::string_view left = rest.substr(separators_at(rest));
  return left.empty() ? name : left;
}

std::string_view letter_of(std::string_view name) {
  constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  const study::Character first = study::first_character(name);
  const char letter = name.empty() ? '\0' : lower(name.front());
  if (letter >= 'a' && letter <= 'z') {
    return capitals.substr(static_cast<std::size_t>(letter - 'a'), 1);
  }
  if (first.code >= 0x3041 && first.code <= 0x309F) return "hiragana";
  if (first.code >= 0x30A0 && first.code <= 0x30FF) return "katakana";
  if (first.code >= 0x4E00 && first.code <= 0x9FFF) return "kanji";
  return name.substr(0, first.bytes);
}

bool matches(std::string_view name, std::string_view typed) {
  const auto same = [](char a, char b) { return lower(a) == lower(b); };
  return typed.empty() ||
         std::search(name.begin(), name.end(), typed.begin(), typed.end(), same) != name.end();
}

}  // namespace promenade::app
