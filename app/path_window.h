// The window of `promenade graph path --window`: a path is drawn with the mouse, and the figure
// walks it.
#pragma once

#include <memory>
#include <string>

#include "app/path_drawing.h"

namespace promenade::app {

struct PathWindowSetting {
  std::shared_ptr<const motion::MotionGraph> graph;
  motion::PathWalkOptions options;  // all but the parts
  PathDrawing drawing;              // with which it opens; may be empty
  std::string out;                  // the capture that Save writes; empty: there is no Save
};

// Returns when the window is closed. Throws OutsideError without a display.
void draw_path_in_window(const PathWindowSetting& setting);

}  // namespace promenade::app
