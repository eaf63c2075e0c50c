#include "app/screens/items.h"

namespace promenade::app {
namespace {

// Questions that the study itself asks ([[rating]]) have no title of their own.
std::string_view title_of(const Screen& screen, const study::Instrument& instrument) {
  const std::string& own = study::text_in(instrument.title, screen.language);
  return own.empty() ? screen.texts("rating.title") : own;
}

std::string_view hint_of(const Screen& screen, const study::Instrument& instrument) {
  return instrument.title.empty() ? std::string_view(screen.texts("rating.hint")) : "";
}

std::string missing_of(const Screen& screen, const Sheet& sheet) {
  int count = 0;
  const study::Item* open = first_open(sheet, count);
  if (open == nullptr) return "";
  return screen.texts.with("items.missing", {{"question", name_of(screen, *open)}});
}

}  // namespace

void draw_questionnaire(const Screen& screen) {
  const Sheet sheet = sheet_of(screen);
  take_digits(screen, sheet);
  const std::string missing = missing_of(screen, sheet);
  bool pressed = false;
  const float top = draw_text_page(screen,
                                   {.title = title_of(screen, sheet.instrument),
                                    .text = hint_of(screen, sheet.instrument),
                                    .button = screen.texts("button.continue"),
                                    .missing = missing},
                                   screen.session.can_continue(), pressed);
  const Box column = screen.ui.layout.column();
  draw_sheet(screen, sheet, {column.x, top, column.width, column.bottom() - top}, false);
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

}  // namespace promenade::app
