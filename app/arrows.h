// Arrows on small buttons: a row goes up or down, a list is folded or unfolded.
#pragma once

#include "app/widgets.h"

namespace promenade::app {

enum class Arrow { up, down, folded, unfolded };

void draw_arrow(const Box& box, Arrow arrow, const Rgb& colour, float thickness);

// A square button; true: pressed and released on it.
bool arrow_button(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                  Arrow arrow, bool enabled = true);

}  // namespace promenade::app
