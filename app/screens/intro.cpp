#include "app/screens/screen.h"

namespace promenade::app {
namespace {

// Nobody should look for controls that are no longer there.
std::string controls_text(const Screen& screen) {
  const auto trial = static_cast<std::size_t>(screen.session.page().trial);
  const std::vector<study::PlannedTrial>& trials = screen.session.plan().trials;
  const bool same = trial > 0 && trials[trial - 1].interface == trials[trial].interface;
  if (same || trials[trial].interface < 0) return "";
  return "\n\n" +
         screen.texts.with("intro.controls", {{"title", title_of(screen, use_of(screen))}});
}

}  // namespace

void draw_intro(const Screen& screen) {
  const std::string text =
      ask(screen, "intro") + controls_text(screen) + "\n\n" + screen.texts("intro.ready");
  bool pressed = false;
  draw_text_page(screen, {screen.texts("intro.title"), text, screen.texts("button.start")}, true,
                 pressed);
  if (pressed) screen.actions.emplace_back(study::Continue{});
  if (screen.session.can_go_back() &&
      button(screen.ui, "back", screen.ui.layout.box(320, 640, 280, 48), screen.texts("intro.back"),
             ButtonKind::quiet)) {
    screen.actions.emplace_back(study::Back{});
  }
}

}  // namespace promenade::app
