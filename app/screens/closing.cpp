#include "app/screens/screen.h"

namespace promenade::app {
namespace {

// The code is all that leads back to the person.
std::string code_text(const Screen& screen) {
  const bool all = screen.bundle.study.safety.withdrawal == study::Withdrawal::everything;
  return screen.texts.with(all ? "closing.everything" : "closing.link",
                           {{"code", std::string(screen.participant)}});
}

// For the experimenter, who comes to the screen now.
void draw_copy_problem(const Screen& screen) {
  if (screen.copy_problem == nullptr) return;
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  const float height = ui.layout.size(72);
  fill({0, 0, ImGui::GetIO().DisplaySize.x, height}, palette.alarm);
  const Box line = ui.layout.box(32, 8, 1216, 28);
  draw_line(ui.look.fonts.bold, {line.x, ui.layout.size(8), line.width, line.height},
            palette.on_colour, screen.texts("closing.copy_problem"));
  draw_line(ui.look.fonts.text, {line.x, ui.layout.size(36), line.width, line.height},
            palette.on_colour, screen.copy_problem);
}

}  // namespace

void draw_closing(const Screen& screen) {
  const bool thanks = screen.session.page().kind == study::PageKind::thanks;
  const std::string prefix = thanks ? "thanks." : "declined.";
  const std::string text = screen.texts(prefix + "text") + "\n\n" + code_text(screen);
  bool pressed = false;
  draw_text_page(screen, {screen.texts(prefix + "title"), text, screen.texts("button.close")}, true,
                 pressed);
  draw_copy_problem(screen);
  if (pressed) screen.actions.emplace_back(study::Continue{});
}

// The session waits; the window can be closed.
void draw_left(const Screen& screen) {
  bool pressed = false;
  const std::string text =
      screen.texts.with("left.text", {{"code", std::string(screen.participant)}});
  draw_text_page(screen, {screen.texts("left.title"), text, screen.texts("button.close")}, true,
                 pressed);
  if (pressed) screen.memory.wants_close = true;
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
