#include "app/screens/screen.h"

namespace promenade::app {

void draw_intro(const Screen& screen) {
  const std::string text = ask(screen, "intro") + "\n\n" + screen.texts("intro.ready");
  bool pressed = false;
  draw_text_page(screen, {screen.texts("intro.title"), text, screen.texts("button.start")}, true,
                 pressed);
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

}  // namespace promenade::app
