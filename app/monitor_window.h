// The window of `promenade monitor`.
#pragma once

#include <string>

namespace promenade::app {

// Returns when the window is closed. `screen`: the display that it fills, from 1; 0: a window of
// 1280 x 720. Throws OutsideError without a display.
void watch_in_window(const std::string& database, int screen);

}  // namespace promenade::app
