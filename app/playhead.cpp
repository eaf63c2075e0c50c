#include "app/playhead.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace promenade::app {

void Playhead::pass(std::int64_t passed_us) {
  if (playing_) go_to(t_us_ + speed_ * static_cast<double>(passed_us));
}

void Playhead::press(int glfw_key) {
  constexpr double second_us = 1e6;
  switch (glfw_key) {
    case GLFW_KEY_SPACE:
      if (at_end()) t_us_ = 0;
      playing_ = !playing_;
      break;
    case GLFW_KEY_LEFT:
      return go_to(t_us_ - second_us);
    case GLFW_KEY_RIGHT:
      return go_to(t_us_ + second_us);
    case GLFW_KEY_ESCAPE:
      closed_ = true;
      break;
    default:
      break;
  }
}

// It stops at the end.
void Playhead::go_to(double t_us) {
  const auto length_us = static_cast<double>(length_us_);
  t_us_ = std::clamp(t_us, 0.0, length_us);
  if (t_us_ >= length_us) playing_ = false;
}

std::string_view Playhead::hint() const {
  if (playing_) return "Space: pause   arrows: 1 s   Esc: close";
  return at_end() ? "the end   Space: again   arrows: 1 s   Esc: close"
                  : "paused   Space: go on   arrows: 1 s   Esc: close";
}

}  // namespace promenade::app
