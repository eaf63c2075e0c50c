#include "app/screens/screen.h"

namespace promenade::app {

void draw_closing(const Screen& screen) {
  const bool thanks = screen.session.page().kind == study::PageKind::thanks;
  const std::string prefix = thanks ? "thanks." : "declined.";
  bool pressed = false;
  draw_text_page(
      screen,
      {screen.texts(prefix + "title"), screen.texts(prefix + "text"), screen.texts("button.close")},
      true, pressed);
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

// The reason is for the experimenter: main says it once the window is closed.
void draw_failure(const Screen& screen) {
  bool pressed = false;
  draw_text_page(
      screen,
      {screen.texts("error.title"), screen.texts("error.text"), screen.texts("button.close")}, true,
      pressed);
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

}  // namespace promenade::app
