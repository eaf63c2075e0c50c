// Where things are on screen: at 1280 x 720 as drawn here, scaled to any window
// and centred in it.
#pragma once

#include "app/box.h"

namespace promenade::app {

// Where the figures of a trial are, pixels.
struct StagePlan {
  Box figures;              // their part of the stage
  float figure_height = 0;  // of a figure of middling height
  float foot_y = 0, plate_y = 0;
  Box transport;  // play, pause, slow and scrub
  Box wall;       // all examples walking; empty: not here
};

struct Layout {
  float scale = 1;
  float left = 0, top = 0;  // of the 1280 x 720 picture, pixels

  // A rectangle given at 1280 x 720, on whole pixels.
  Box box(float x, float y, float width, float height) const;
  float size(float at_720) const;  // a length, rounded to whole pixels

  // The trial.
  Box strip() const { return box(0, 0, 1280, 56); }
  Box stage() const { return box(16, 64, 816, 640); }
  Box panel() const { return box(848, 64, 416, 568); }
  Box start_over() const { return box(848, 648, 136, 48); }
  Box undo() const { return box(992, 648, 48, 48); }
  Box redo() const { return box(1040, 648, 48, 48); }
  Box done() const { return box(1104, 648, 160, 48); }
  StagePlan stage_plan(bool with_wall) const;
  // The figures beside the text of the instructions.
  StagePlan instructions_plan() const;
  // Pages of text.
  Box column() const { return box(320, 96, 640, 528); }
};

// `share`: of the window that the picture may take.
Layout make_layout(int width, int height, double share = 1);

}  // namespace promenade::app
