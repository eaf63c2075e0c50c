// What only a window can tell: two figures walk in it as in a trial, and the frames and
// the gaps between two looks at the input are timed.
#pragma once

#include <functional>

#include "app/doctor/findings.h"
#include "app/figure/renderer.h"
#include "app/gui.h"
#include "app/window/gui_renderer.h"
#include "app/window/window.h"
#include "study/study.h"

namespace promenade::app {

// A window and all that draws in it; the gui has been fitted and its fonts are on the card.
struct Canvas {
  Window& window;
  Gui& gui;
  GuiRenderer& gui_renderer;
  FigureRenderer& renderer;
};

struct ScreenTest {
  std::size_t frames = 60;             // that are timed
  double longest_s = 2;                // however few they are by then
  const char* caption = "";            // what people read meanwhile
  std::function<bool()> stopped = {};  // by Ctrl-C or by closing the window; empty: never
};

DisplayFinding describe_display(const Window& window);

// Fills `pacing` and `input` of the findings.
void measure_screen(const Canvas& canvas, const study::StudyBundle& bundle, const ScreenTest& test,
                    Findings& findings);

}  // namespace promenade::app
