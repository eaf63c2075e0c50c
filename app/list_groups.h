// How a list of motions falls into groups with headings, and which of its names match what
// was typed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "motion/motion_set.h"

namespace promenade::app {

enum class Grouping { style, alphabet, none };

// For each cycle the number of its group: cycles of one style, and styles that share what
// stands before their last hyphen ("excitement-fast", "excitement-slow").
std::vector<int> style_groups(const motion::MotionSet& set);

// "style", "alphabet", "none", or "auto": by style when that makes groups of two and more,
// else by letter when there are more than twenty, else not at all.
Grouping grouping_of(std::string_view wanted, const std::vector<int>& groups);

// Of the first `length` bytes of a name, how many it shares with another, up to the end of a
// word: "excited, fast" and "excited, slow" share "excited". 0: nothing. Taken from name to
// name it is what all of them share.
std::size_t shared_beginning(std::string_view name, std::size_t length, std::string_view other);

// What is left of a name under the heading that it begins with; the name if that is all.
std::string_view after_heading(std::string_view name, std::size_t heading);

// Under which letter a name stands: "A" to "Z"; of Japanese "hiragana", "katakana" or "kanji",
// since few names share a character; else its first character.
std::string_view letter_of(std::string_view name);

// Is `typed` a part of the name? Capitals of ASCII are as good as small letters.
bool matches(std::string_view name, std::string_view typed);

}  // namespace promenade::app
