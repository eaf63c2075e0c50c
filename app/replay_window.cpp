#include "app/replay_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/photograph.h"
#include "app/playhead.h"
#include "app/print.h"
#include "app/registry.h"
#include "app/replay_view.h"
#include "app/window/clock.h"
#include "app/window/frame_loop.h"
#include "app/window/gui_renderer.h"
#include "app/window/off_screen.h"

namespace promenade::app {
namespace {

// What both need, in the order in which it is made.
class Projector {
 public:
  Projector(const ReplaySetting& setting, const WindowOptions& options)
      : player(setting.bundle, interfaces(), setting.log, setting.trial),
        window(options, queue),
        gui_(make_palette(setting.bundle.study.display.paper_colours),
             replayed_words(setting.bundle, setting.log)),
        view_(setting.bundle, interfaces(), setting.log, player, gui_) {}

  void draw_figures(int width, int height) {
    if (view_.fit(width, height)) gui_renderer_.upload_fonts();
    renderer_.begin(width, height, gui_.look().palette.background);
    view_.draw_figures(renderer_);
  }
  void draw_page(std::string_view hint = "") {
    view_.frame(hint);
    gui_renderer_.draw();
  }
  // So that the small figures of the page are known before it is drawn.
  void ask(int width, int height) {
    if (view_.fit(width, height)) gui_renderer_.upload_fonts();
    view_.frame();
  }

  TrialPlayer player;  // first: a trial that cannot be played opens no window
  InputQueue queue;
  Window window;

 private:
  Gui gui_;
  GuiRenderer gui_renderer_;
  FigureRenderer renderer_;
  ReplayView view_;
};

std::int64_t picture_us(int picture, double fps, double speed) {
  return std::llround(1e6 * speed / fps * picture);
}

}  // namespace

void play_in_window(const ReplaySetting& setting, bool windowed) {
  const int screen = windowed ? 0 : setting.bundle.study.display.screen;
  require_display(screen);
  require_fonts();
  Projector projector(setting,
                      {.title = "Promenade: replay", .windowed = windowed, .screen = screen});
  Window& window = projector.window;
  Playhead head(projector.player.length_us(), setting.speed);
  projector.ask(window.width(), window.height());
  projector.draw_page();
  std::int64_t before_us = monotonic_us();
  const auto draw_figures = [&](std::int64_t now_us) {
    head.pass(now_us - before_us);
    before_us = now_us;
    projector.player.move_to(head.t_us());
    projector.draw_figures(window.width(), window.height());
  };
  const auto draw_screen = [&](std::int64_t) {
    while (const std::optional<UiEvent> event = projector.queue.take()) {
      if (event->kind == UiEvent::Kind::key && event->down) head.press(event->code);
    }
    projector.draw_page(head.hint());
  };
  run_frames(window, {.draw_figures = draw_figures,
                      .draw_screen = draw_screen,
                      .shown = [](const ShownFrame&) {},
                      .ended = [&] { return head.closed() || window.closing() || interrupted(); }});
}

int count_pictures(std::int64_t length_us, double fps, double speed) {
  return 1 + static_cast<int>(std::ceil(1e-6 * static_cast<double>(length_us) * fps / speed));
}

int write_pictures(const ReplaySetting& setting, const PictureSetting& pictures) {
  require_display();
  require_fonts();
  Projector projector(setting, {.title = "Promenade: pictures", .windowed = true, .hidden = true});
  const OffScreen screen(pictures.width, pictures.height);
  const int count = count_pictures(projector.player.length_us(), pictures.fps, setting.speed);
  for (int k = 0; k < count; ++k) {
    projector.player.move_to(picture_us(k, pictures.fps, setting.speed));
    projector.ask(pictures.width, pictures.height);
    projector.draw_figures(pictures.width, pictures.height);
    projector.draw_page();
    write_png(pictures.folder / fmt::format("frame-{:05}.png", k + 1),
              photograph(pictures.width, pictures.height));
    if (!pictures.progress(k + 1, count)) return k + 1;
  }
  return count;
}

}  // namespace promenade::app
