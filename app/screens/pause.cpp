// Rest: the page between two blocks, and the one over any other page.
#include <fmt/format.h>

#include "app/screens/screen.h"

namespace promenade::app {

void draw_break(const Screen& screen) {
  const Ui& ui = screen.ui;
  bool pressed = false;
  const float below = draw_text_page(
      screen,
      {screen.texts("break.title"), screen.texts("break.text"), screen.texts("button.continue")},
      screen.session.can_continue(), pressed);
  const std::int64_t left_s = (screen.session.break_left_us() + 999'999) / 1'000'000;
  if (left_s > 0) {
    const std::string time = fmt::format("{}:{:02}", left_s / 60, left_s % 60);
    const Box column = ui.layout.column();
    draw_text(ui.look.fonts.reading,
              {column.x, below + ui.layout.size(32), column.width, ui.layout.size(32)},
              ui.look.palette.quiet, screen.texts.with("break.left", {{"time", time}}));
  }
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

// Nothing of what is beneath can be seen, so that nobody thinks on for free.
void draw_pause(const Screen& screen) {
  const bool ends = screen.memory.asks_to_end;
  std::string text = screen.texts(screen.memory.back_again ? "resume.back" : "pause.text");
  if (ends) text += "\n\n" + screen.texts("pause.end");
  bool pressed = false;
  draw_text_page(screen,
                 {screen.texts(screen.memory.back_again ? "resume.back_title" : "pause.title"), text, screen.texts("button.resume"), "resume"}, true,
                 pressed);
  if (pressed) screen.actions.emplace_back(study::Resume{});
  if (pressed) screen.memory.asks_to_end = screen.memory.back_again = false;
  if (ends && button(screen.ui, "end", screen.ui.layout.box(320, 640, 240, 48),
                     screen.texts("button.end"), ButtonKind::quiet)) {
    screen.memory.wants_end = true;
  }
}

}  // namespace promenade::app
