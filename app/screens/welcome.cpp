#include "app/screens/screen.h"

namespace promenade::app {
namespace {

const char* hint_of(const Screen& screen) {
  if (screen.memory.code_unknown) return "welcome.code_unknown";
  if (screen.memory.code_taken) return "welcome.code_taken";
  if (screen.memory.code_known) return "welcome.code_known";
  return screen.memory.resume_differs ? "resume.differs" : "welcome.code_hint";
}

bool draw_code_field(const Screen& screen, float y) {
  const Ui& ui = screen.ui;
  const Box column = ui.layout.column();
  draw_text(ui.look.fonts.bold, {column.x, y, column.width, ui.layout.size(28)},
            ui.look.palette.text, screen.texts("welcome.code"));
  const float top = y + ui.layout.size(32);
  const Box field{column.x, top, ui.layout.size(280), ui.layout.size(44)};
  Widget widget;
  widget.box = field;
  widget.view = visible_box();
  ui.widgets.add("type", "code", widget);
  ImGui::PushFont(ui.look.fonts.reading);
  const float pad = std::round(0.5f * (field.height - ImGui::GetFontSize()));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.layout.size(12), pad});
  ImGui::SetCursorScreenPos({field.x, field.y});
  ImGui::SetNextItemWidth(field.width);
  const bool by_tab = ui.focus.on("type", "code") && ui.focus.arrived();
  if (screen.fresh || by_tab) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##code", screen.memory.code.data(), screen.memory.code.size(),
                       ImGuiInputTextFlags_CharsNoBlank | ImGuiInputTextFlags_EnterReturnsTrue);
  ScreenMemory& memory = screen.memory;
  if (ImGui::IsItemEdited()) memory.code_known = memory.code_unknown = memory.code_taken = false;
  ImGui::PopStyleVar();
  ImGui::PopFont();
  frame(field, ui.look.palette.quiet, ui.layout.size(1));
  const bool known = memory.code_known;
  const bool refused = known || memory.code_unknown || memory.code_taken;
  draw_text(refused ? ui.look.fonts.bold : ui.look.fonts.text,
            {field.x, field.bottom() + ui.layout.size(4), column.width, ui.layout.size(28)},
            refused ? ui.look.palette.text : ui.look.palette.quiet, screen.texts(hint_of(screen)));
  // Twice by mistake spoils two sessions: somebody has to say that it is none.
  const Box again{field.x, field.bottom() + ui.layout.size(36), ui.layout.size(360),
                  ui.layout.size(44)};
  if (known &&
      button(ui, "same_person", again, screen.texts("welcome.again"), ButtonKind::outlined)) {
    screen.memory.same_person = screen.memory.wants_start = true;
  }
  return entered;
}

}  // namespace

void draw_welcome(const Screen& screen) {
  const study::Study& study = screen.bundle.study;
  const std::string& own = study::text_in(study.title, screen.language);
  const char* const what = study.interfaces.empty() ? "welcome.rating" : "welcome.text";
  const std::string text = screen.texts.with(
      what, {{"count", std::to_string(screen.session.plan().trials.size())}});
  const bool has_code = participant_code_problem(screen.memory.code.data()).empty();
  bool pressed = false;
  const float below = draw_text_page(screen,
                                     {.title = own.empty() ? screen.texts("welcome.title") : own,
                                      .text = text,
                                      .button = screen.texts("button.start"),
                                      .missing = screen.texts("welcome.code_missing")},
                                     has_code, pressed);
  const bool entered = draw_code_field(screen, below + screen.ui.layout.size(32));
  if (entered && !has_code) screen.memory.too_early = true;
  if ((pressed || entered) && has_code) screen.memory.wants_start = true;
}

}  // namespace promenade::app
