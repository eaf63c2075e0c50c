// A rectangle on screen.
#pragma once

namespace promenade::app {

struct Box {  // pixels of the framebuffer, y down
  float x = 0, y = 0, width = 0, height = 0;

  float right() const { return x + width; }
  float bottom() const { return y + height; }
  float middle_x() const { return x + 0.5f * width; }
  float middle_y() const { return y + 0.5f * height; }
  bool holds(float at_x, float at_y) const {
    return at_x >= x && at_x < right() && at_y >= y && at_y < bottom();
  }
};

}  // namespace promenade::app
