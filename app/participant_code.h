// The codes that stand for people.
#pragma once

#include <string>
#include <string_view>

namespace promenade::app {

constexpr int longest_participant_code = 40;  // characters

// What is wrong with a code: it is empty, too long, no UTF-8, or holds control
// characters. Empty: nothing.
std::string participant_code_problem(std::string_view code);

}  // namespace promenade::app
