// The window of `promenade model adjectives --window` and `model features --window`.
#pragma once

#include <string>

#include "app/model_editor.h"

namespace promenade::app {

// Returns when the window is closed. `out`: the file that Save writes; empty: there is no Save.
// Throws OutsideError without a display.
void edit_in_window(ModelEditor editor, const std::string& out);

}  // namespace promenade::app
