// What a rate task has in the place of an interface: the questions about the green walk.
#include "app/screens/items.h"

namespace promenade::app {
namespace {

Box inner(const Screen& screen) {
  const Box panel = screen.ui.layout.panel();
  const float inset = screen.ui.layout.size(16);
  const float above = screen.ui.layout.size(12);
  const float bar = ImGui::GetStyle().ScrollbarSize + screen.ui.layout.size(8);
  return {panel.x + inset, panel.y + above, panel.width - inset - bar, panel.height - above};
}

void draw_back(const Screen& screen) {
  if (!screen.session.can_go_back()) return;
  if (button(screen.ui, "back", screen.ui.layout.box(848, 648, 120, 48), screen.texts("trial.back"),
             ButtonKind::quiet)) {
    screen.actions.emplace_back(study::Back{});
  }
}

}  // namespace

void draw_rate(const Screen& screen) {
  const Sheet sheet = sheet_of(screen);
  take_digits(screen, sheet);
  int open = 0;
  first_open(sheet, open);
  if (task_of(screen).has_done) {
    const std::string missing = screen.texts.with("items.open", {{"count", std::to_string(open)}});
    const Layout& layout = screen.ui.layout;
    const PageTexts texts{.title = {},
                          .text = {},
                          .button = screen.texts("trial.done"),
                          .target = "done",
                          .by_enter = false,
                          .missing = missing,
                          .missing_at = layout.box(976, 648, 120, 48)};
    if (main_button(screen, texts, layout.done(), screen.session.answered())) {
      screen.actions.emplace_back(study::Done{});
    }
  }
  draw_back(screen);
  draw_sheet(screen, sheet, inner(screen), true);
}

void draw_rate_picture(const Screen& screen) {
  const auto index = static_cast<std::size_t>(task_of(screen).instrument);
  draw_sheet_picture(screen, screen.bundle.study.instruments[index], inner(screen));
}

}  // namespace promenade::app
