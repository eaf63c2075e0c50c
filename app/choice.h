// One of several: side by side where there is room, or folded into a line that opens.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/widgets.h"

namespace promenade::app {

// Each option is an answer button, "press" `target`/INDEX; the one that was pressed, when it was
// not the chosen one already.
std::optional<std::size_t> choice_row(const Ui& ui, std::string_view target, const Box& box,
                                      std::span<const std::string> options, std::size_t chosen);

// A line that shows the chosen one, "open" `target`; pressed, it opens a list below, whose rows are
// "choose" `target`/INDEX. The arrow keys change it without opening. `chosen` beyond the options:
// none is.
std::optional<std::size_t> drop_down(const Ui& ui, std::string_view target, const Box& box,
                                     std::span<const std::string> options, std::size_t chosen);

// A square that is ticked or not, with words behind it: "tick" `target`. True: it was pressed.
bool check_box(const Ui& ui, std::string_view target, const Box& box, std::string_view label,
               bool ticked);

}  // namespace promenade::app
