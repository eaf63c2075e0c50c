#include "app/window/frame_loop.h"

#include <epoxy/gl.h>
#include <sched.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/window/clock.h"
#include "motion/quantile.h"

namespace promenade::app {
namespace {

constexpr std::int64_t starved_us = 150'000;  // no card draws so long by itself

// Threads that run while nobody else wants to, or like all others. Going back needs a right
// that not everybody has.
void schedule_renderer_threads(int policy) {
  namespace fs = std::filesystem;
  std::error_code error;
  for (const fs::directory_entry& task : fs::directory_iterator("/proc/self/task", error)) {
    std::ifstream file(task.path() / "comm");
    std::string name;
    std::getline(file, name);
    if (!name.starts_with("llvmpipe-")) continue;
    const std::string number = task.path().filename().string();
    int id = 0;
    std::from_chars(number.data(), number.data() + number.size(), id);
    const sched_param usual{};
    sched_setscheduler(id, policy, &usual);
  }
}

void wait_for_card(Window& window) {
  GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
  std::int64_t patience_us = monotonic_us() + starved_us;
  while (glClientWaitSync(fence, 0, 0) == GL_TIMEOUT_EXPIRED) {
    window.wait_events(0.0005);
    if (monotonic_us() < patience_us) continue;
    schedule_renderer_threads(SCHED_OTHER);
    patience_us = INT64_MAX;
  }
  glDeleteSync(fence);
}

void wait_until(Window& window, std::int64_t due_us) {
  for (std::int64_t left = due_us - monotonic_us(); left > 0; left = due_us - monotonic_us()) {
    window.wait_events(static_cast<double>(left) * 1e-6);
  }
}

}  // namespace

double quantile_ms(const std::vector<std::int64_t>& times_us, double share) {
  if (times_us.empty()) return 0;
  return 1e-3 * motion::quantile({times_us.begin(), times_us.end()}, share);
}

FrameTimes run_frames(Window& window, const FrameHooks& hooks, double hz) {
  FrameTimes times;
  const double rate = window.refresh_hz() > 0 ? window.refresh_hz() : hz;
  const auto period_us = static_cast<std::int64_t>(1e6 / rate);
  std::int64_t due_us = monotonic_us();
  std::int64_t last_us = 0;
  while (!hooks.ended()) {
    const std::int64_t start_us = monotonic_us();
    hooks.draw_figures(start_us);
    window.poll();
    hooks.draw_screen(monotonic_us());
    wait_for_card(window);
    window.swap();
    const std::int64_t shown_us = monotonic_us();
    const std::int64_t interval_us = last_us > 0 ? shown_us - last_us : period_us;
    const bool late = interval_us > period_us + period_us / 2;
    hooks.shown({.shown_us = shown_us,
                 .interval_us = last_us > 0 ? interval_us : 0,
                 .work_us = shown_us - start_us,
                 .late_us = late ? interval_us - period_us : 0});
    times.work_us.push_back(shown_us - start_us);
    if (last_us > 0) times.interval_us.push_back(interval_us);
    last_us = shown_us;
    // After a late frame the beat starts anew instead of catching up.
    due_us = std::max(due_us + period_us, shown_us - period_us);
    wait_until(window, due_us);
  }
  return times;
}

void run_slowly(Window& window, const std::function<void(std::int64_t now_us)>& draw,
                const std::function<bool()>& ended, std::int64_t period_us) {
  constexpr std::int64_t least_us = 50'000;
  while (!ended()) {
    const std::int64_t start_us = monotonic_us();
    window.poll();
    draw(start_us);
    wait_for_card(window);
    window.swap();
    wait_until(window, start_us + least_us);
    const std::int64_t left_us = start_us + period_us - monotonic_us();
    if (left_us > 0) window.wait_events(static_cast<double>(left_us) * 1e-6);
  }
}

void let_renderer_threads_idle() { schedule_renderer_threads(SCHED_IDLE); }

}  // namespace promenade::app
