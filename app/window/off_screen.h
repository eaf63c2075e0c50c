// A picture of any size to draw to instead of a window, which may be hidden or smaller.
#pragma once

namespace promenade::app {

class OffScreen {
 public:
  // From now on everything is drawn here. Needs a current context for its whole life.
  // Throws OutsideError for a size that the graphics card cannot do.
  OffScreen(int width, int height);
  ~OffScreen();  // and now to the window again
  OffScreen(const OffScreen&) = delete;
  OffScreen& operator=(const OffScreen&) = delete;

 private:
  unsigned int frame_ = 0, colour_ = 0, depth_ = 0;
};

}  // namespace promenade::app
