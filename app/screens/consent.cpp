#include "app/screens/screen.h"

namespace promenade::app {

void draw_consent(const Screen& screen) {
  const std::string& own = study::text_in(screen.bundle.study.consent, screen.language);
  bool agreed = false;
  // Nobody agrees by an accidental Enter.
  draw_text_page(screen,
                 {screen.texts("consent.title"), own.empty() ? screen.texts("consent.text") : own,
                  screen.texts("button.agree"), "continue", false},
                 true, agreed);
  if (agreed) screen.actions.emplace_back(study::Continue{});
  // As large as the other button: declining is no second-class answer.
  if (button(screen.ui, "decline", screen.ui.layout.box(320, 640, 200, 48),
             screen.texts("button.decline"), ButtonKind::outlined)) {
    screen.actions.emplace_back(study::Decline{});
  }
}

}  // namespace promenade::app
