#include "app/screens/screen.h"

namespace promenade::app {

// Each language asks and answers in its own words.
void draw_language(const Screen& screen) {
  const Ui& ui = screen.ui;
  float y = 120;
  for (const OfferedLanguage& language : screen.languages) {
    draw_text(ui.look.fonts.title, ui.layout.box(320, y, 640, 40), ui.look.palette.text,
              language.ask, Align::centre);
    y += 44;
  }
  y += 36;
  for (const OfferedLanguage& language : screen.languages) {
    const Box box = ui.layout.box(440, y, 400, 72);
    if (button(ui, "language:" + language.code, box, "", ButtonKind::outlined)) {
      screen.actions.emplace_back(study::ChooseLanguage{language.code});
    }
    draw_text(ui.look.fonts.title, box, ui.look.palette.text, language.name, Align::centre);
    y += 88;
  }
}

}  // namespace promenade::app
