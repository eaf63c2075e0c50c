// What the widgets of a questionnaire are called in the map: the pages draw them, the
// autopilot and the tests look for them.
#pragma once

#include <fmt/format.h>

#include <string>

namespace promenade::app {

// A value of a scale, as it is written.
inline std::string value_text(double value) { return fmt::format("{:.6g}", value); }

// "press": a value of a scale, or a choice by its place from 1.
inline std::string answer_target(const std::string& item, double value) {
  return "answer:" + item + ":" + value_text(value);
}
// "press": an option of a ranking; the box of an agreement; not to answer.
inline std::string rank_target(const std::string& item, const std::string& option) {
  return "rank:" + item + ":" + option;
}
inline std::string agree_target(const std::string& item) { return "agree:" + item; }
inline std::string decline_target(const std::string& item) { return "decline:" + item; }
// "type": a text or a number; the own words of a free choice.
inline std::string words_target(const std::string& item) { return "words:" + item; }
inline std::string own_target(const std::string& item) { return "own:" + item; }

}  // namespace promenade::app
