#include "app/model_window.h"

#include "app/figure/renderer.h"
#include "app/model_file.h"
#include "app/model_view.h"
#include "app/print.h"
#include "app/window/frame_loop.h"
#include "app/window/gui_renderer.h"
#include "motion/files.h"

namespace promenade::app {

void edit_in_window(ModelEditor editor, const std::string& out) {
  require_display();
  require_fonts();
  InputQueue queue;
  Window window({.title = "Promenade: " + editor.title(), .windowed = true}, queue);
  Gui gui(make_palette(false), shown_words(editor));
  GuiRenderer gui_renderer;
  FigureRenderer renderer;
  std::function<void(const study::AdjectiveModel&)> save;
  if (!out.empty())
    save = [&out](const study::AdjectiveModel& model) { write_file(out, model_file(model)); };
  ModelView view(editor, gui, queue, save);
  const auto draw_ground = [&](std::int64_t) {
    if (gui.fit(window.width(), window.height())) gui_renderer.upload_fonts();
    renderer.begin(window.width(), window.height(), gui.look().palette.background);
  };
  const auto draw_screen = [&](std::int64_t) {
    view.frame();
    gui_renderer.draw();
  };
  run_frames(window, {.draw_figures = draw_ground,
                      .draw_screen = draw_screen,
                      .shown = [](const ShownFrame&) {},
                      .ended = [&] { return window.closing() || interrupted(); }});
}

}  // namespace promenade::app
