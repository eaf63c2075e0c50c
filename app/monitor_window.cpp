#include "app/monitor_window.h"

#include "app/figure/renderer.h"
#include "app/monitor_view.h"
#include "app/print.h"
#include "app/registry.h"
#include "app/window/frame_loop.h"
#include "app/window/growing_gui.h"
#include "study/identity.h"

namespace promenade::app {
namespace {

constexpr std::int64_t period_us = 500'000;  // at most so often the database is looked at

}  // namespace

void watch_in_window(const std::string& database, int screen) {
  require_display(screen);
  require_fonts();
  InputQueue queue;
  const bool whole = screen > 0;  // and then it must not take the keyboard from who plays
  Window window({.title = "Promenade: " + database,
                 .windowed = !whole,
                 .screen = screen,
                 .shows_only = whole},
                queue);
  study::Watch watch(database, interfaces());
  const study::Watched* now = nullptr;
  std::int64_t looked_us = 0;
  GrowingGui fonts(make_palette(false));
  FigureRenderer ground;
  MonitorView view(queue);
  const auto draw = [&](std::int64_t now_us) {
    if (now == nullptr || now_us - looked_us >= period_us) {
      now = &watch.look(study::utc_now());
      looked_us = now_us;
    }
    Gui& gui = fonts.gui_for(shown_words(*now), window);
    ground.begin(window.width(), window.height(), gui.look().palette.background);
    view.frame(gui, *now);
    fonts.renderer().draw();
  };
  run_slowly(
      window, draw, [&] { return window.closing() || interrupted(); }, period_us);
}

}  // namespace promenade::app
