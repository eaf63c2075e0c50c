// The frames of a window, in the order that stamps input best on one thread:
// draw the figures; poll; draw the screen; while the graphics card works, wait for
// events; swap; wait for events until the next frame is due.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "app/window/shown_frame.h"
#include "app/window/window.h"

namespace promenade::app {

struct FrameHooks {
  std::function<void(std::int64_t now_us)> draw_figures;
  std::function<void(std::int64_t now_us)> draw_screen;  // after the poll
  std::function<void(const ShownFrame& frame)> shown;
  std::function<bool()> ended;
};

// How the frames were, for the log and for measurements.
struct FrameTimes {
  std::vector<std::int64_t> work_us;      // from the start of a frame to its swap
  std::vector<std::int64_t> interval_us;  // from swap to swap
};

// A quantile (0 to 1) of some of these times, milliseconds; 0 without any.
double quantile_ms(const std::vector<std::int64_t>& times_us, double share);

// Runs until ended() says so. `hz`: frames a second when the display does not say.
FrameTimes run_frames(Window& window, const FrameHooks& hooks, double hz = 60);

// For a window beside others that must not be held up: a frame every `period_us`, and when
// something arrives, but never more than 20 in a second.
void run_slowly(Window& window, const std::function<void(std::int64_t now_us)>& draw,
                const std::function<bool()>& ended, std::int64_t period_us);

// Software OpenGL works in threads of its own; they must not hold up the input. Where
// other programs leave them no time at all, run_frames lets them compete again, if it may.
void let_renderer_threads_idle();

}  // namespace promenade::app
