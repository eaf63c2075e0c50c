// Breaking text into lines: at spaces, and between any two Japanese characters
// except where a line must not begin or end.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

namespace promenade::app {

// Lines of at most `width`, in the unit of measure(text). A word that is too wide
// stays on a line of its own. Views into `text`.
std::vector<std::string_view> break_lines(std::string_view text, float width,
                                          const std::function<float(std::string_view)>& measure);

// Where the first of those lines ends. No allocation.
std::size_t first_line(std::string_view text, float width,
                       const std::function<float(std::string_view)>& measure);

}  // namespace promenade::app
