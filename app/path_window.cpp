#include "app/path_window.h"

#include "app/path_view.h"
#include "app/print.h"
#include "app/window/frame_loop.h"
#include "app/window/gui_renderer.h"
#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/take_clip.h"

namespace promenade::app {

void draw_path_in_window(const PathWindowSetting& setting) {
  require_display();
  require_fonts();
  InputQueue queue;
  Window window({.title = "Promenade: a path", .windowed = true}, queue);
  Gui gui(make_palette(false), shown_words(*setting.graph));
  GuiRenderer gui_renderer;
  FigureRenderer renderer;
  PathDrawing drawing = setting.drawing;
  PathStage stage(setting.graph);
  PathWorker worker(setting.graph, setting.options);
  std::function<void(const motion::Take&)> save;
  if (!setting.out.empty()) {
    save = [&](const motion::Take& take) {
      write_file(setting.out, motion::bvh_text(motion::take_clip(take)));
    };
  }
  PathView view({*setting.graph, drawing, worker, stage}, gui, queue, save);
  const auto draw_figures = [&](std::int64_t now_us) {
    if (gui.fit(window.width(), window.height())) gui_renderer.upload_fonts();
    renderer.begin(window.width(), window.height(), gui.look().palette.background);
    stage.advance(now_us);
    stage.draw(renderer, gui.layout(), gui.look().palette);
  };
  const auto draw_screen = [&](std::int64_t) {
    view.frame();
    gui_renderer.draw();
  };
  run_frames(window, {.draw_figures = draw_figures,
                      .draw_screen = draw_screen,
                      .shown = [](const ShownFrame&) {},
                      .ended = [&] { return window.closing() || interrupted(); }});
}

}  // namespace promenade::app
