#include "app/screens/screen.h"

namespace promenade::app {
namespace {

using study::PageKind;

void draw_page(const Screen& screen) {
  if (screen.failure != nullptr) return draw_failure(screen);
  switch (screen.session.page().kind) {
    case PageKind::welcome:
      return draw_welcome(screen);
    case PageKind::consent:
      return draw_consent(screen);
    case PageKind::instructions:
      return draw_instructions(screen);
    case PageKind::intro:
      return draw_intro(screen);
    case PageKind::trial:
      return draw_trial(screen);
    case PageKind::rating:
      return draw_rating(screen);
    case PageKind::thanks:
    case PageKind::declined:
      return draw_closing(screen);
  }
}

// Sessions that do not count say so, outside everything else.
void draw_marks(const Screen& screen) {
  const Ui& ui = screen.ui;
  if (!screen.pilot && !screen.simulated) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  if (screen.pilot) frame({0, 0, size.x, size.y}, ui.look.palette.pilot, ui.layout.size(6));
  const Box box = ui.layout.box(16, 6, 640, 16);
  draw_text(ui.look.fonts.text, box, ui.look.palette.quiet,
            screen.texts(screen.pilot ? "session.pilot" : "session.simulated"));
}

}  // namespace

void draw_screen(const Screen& screen) {
  const ImGuiIO& io = ImGui::GetIO();
  screen.ui.widgets.clear();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::PushFont(screen.ui.look.fonts.text);
  ImGui::Begin("page", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  draw_page(screen);
  draw_marks(screen);
  ImGui::End();
  ImGui::PopFont();
}

float draw_text_page(const Screen& screen, const PageTexts& texts, bool enabled, bool& pressed) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  const Box column = ui.layout.column();
  const float heading = ui.layout.size(56);
  draw_text(ui.look.fonts.heading, {column.x, column.y, column.width, heading}, palette.text,
            texts.title);
  const float from = column.y + heading + ui.layout.size(16);
  const float height = draw_paragraphs(ui.look.fonts.reading, column.x, from, column.width,
                                       palette.text, texts.text);
  pressed = button(ui, "continue", ui.layout.box(760, 640, 200, 48), texts.button,
                   ButtonKind::filled, enabled);
  return from + height;
}

const study::PlannedTrial& planned_trial(const Screen& screen) {
  return screen.session.plan().trials[static_cast<std::size_t>(screen.session.page().trial)];
}

const study::Task& task_of(const Screen& screen) {
  return screen.bundle.study.tasks[static_cast<std::size_t>(planned_trial(screen).task)];
}

std::string ask(const Screen& screen, const std::string& prefix) {
  if (task_of(screen).kind == study::TaskKind::match) return screen.texts(prefix + ".match");
  const study::Target& target = study::target_of(screen.bundle.study, planned_trial(screen));
  return screen.texts.with(prefix + ".find",
                           {{"quality", study::text_in(target.quality, screen.language)}});
}

}  // namespace promenade::app
