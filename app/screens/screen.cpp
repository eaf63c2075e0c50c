#include "app/screens/screen.h"

namespace promenade::app {
namespace {

using study::PageKind;

void draw_page(const Screen& screen) {
  switch (screen.session.page().kind) {
    case PageKind::language:
      return draw_language(screen);
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
    case PageKind::questionnaire:
      return draw_questionnaire(screen);
    case PageKind::break_:
    case PageKind::release:
      return draw_break(screen);
    case PageKind::thanks:
    case PageKind::declined:
      return draw_closing(screen);
  }
}

void offer_pause(const Screen& screen) {
  const PageKind kind = screen.session.page().kind;
  if (!can_pause(kind)) return;
  // A field that is written in and a list that is searched use the key first.
  const bool used = ImGui::GetIO().WantTextInput || screen.ui.focus.escape_used();
  bool wanted = !used && key_pressed(ImGuiKey_Escape, false);
  if (kind != PageKind::trial) {
    const std::string& label = screen.texts("button.pause");
    const float width = text_width(screen.ui.look.fonts.text, label) + screen.ui.layout.size(32);
    const Box corner = screen.ui.layout.box(1264, 16, 0, 40);
    wanted |= button(screen.ui, "pause", {corner.x - width, corner.y, width, corner.height}, label,
                     ButtonKind::quiet);
  }
  if (wanted) screen.actions.emplace_back(study::Pause{});
}

void draw_all(const Screen& screen) {
  if (screen.failure != nullptr) return draw_failure(screen);
  if (!screen.memory.offered.empty()) return draw_resume(screen);
  if (screen.session.paused()) return draw_pause(screen);
  draw_page(screen);
  offer_pause(screen);
}

// Sessions that do not count say so, outside everything else.
void draw_marks(const Screen& screen) {
  const Ui& ui = screen.ui;
  if (!screen.pilot && !screen.simulated) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  if (screen.pilot) frame({0, 0, size.x, size.y}, ui.look.palette.pilot, ui.layout.size(6));
  const Box box = ui.layout.box(24, 690, 640, 20);
  draw_text(ui.look.fonts.text, box, ui.look.palette.quiet,
            screen.texts(screen.pilot ? "session.pilot" : "session.simulated"));
}

}  // namespace

bool can_pause(PageKind kind) {
  return kind == PageKind::consent || kind == PageKind::instructions || kind == PageKind::intro ||
         kind == PageKind::trial || kind == PageKind::questionnaire || kind == PageKind::break_;
}

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
  draw_all(screen);
  draw_marks(screen);
  ImGui::End();
  ImGui::PopFont();
}

namespace {

// Returns where it ends on screen.
float draw_long_text(const Screen& screen, const Box& box, std::string_view text) {
  ImFont* const font = screen.ui.look.fonts.reading;
  const Rgb& colour = screen.ui.look.palette.text;
  const float height = paragraphs_height(font, box.width, text);
  if (height <= box.height) {
    draw_paragraphs(font, box.x, box.y, box.width, colour, text);
    return box.y + height;
  }
  const float top = begin_body(screen, box, height);
  draw_paragraphs(font, box.x, top, box.width, colour, text);
  end_body(screen, box, top + height);
  return box.bottom();
}

// Whoever presses too early reads what is missing.
void draw_missing(const Screen& screen, const PageTexts& texts, bool enabled, bool by_key) {
  bool& too_early = screen.memory.too_early;
  const bool focused = screen.ui.focus.on("press", texts.target) &&
                       (key_pressed(ImGuiKey_Enter, false) || key_pressed(ImGuiKey_Space, false));
  if (screen.fresh) too_early = false;
  too_early = !enabled && (too_early || by_key || focused || ImGui::IsItemActivated());
  if (!too_early || texts.missing.empty()) return;
  const Box box = screen.ui.layout.box(320, 640, 424, 48);
  draw_text(screen.ui.look.fonts.bold, box, screen.ui.look.palette.text, texts.missing);
}

}  // namespace

float draw_text_page(const Screen& screen, const PageTexts& texts, bool enabled, bool& pressed) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  const Box column = ui.layout.column();
  const float heading = ui.layout.size(56);
  draw_just_ended(screen, ui.layout.box(320, 52, 640, 36));
  draw_text(ui.look.fonts.heading, {column.x, column.y, column.width, heading}, palette.text,
            texts.title);
  const float from = column.y + heading + ui.layout.size(16);
  const float bottom =
      draw_long_text(screen, {column.x, from, column.width, column.bottom() - from}, texts.text);
  pressed = main_button(screen, texts, ui.layout.box(760, 640, 200, 48), enabled);
  return bottom;
}

bool main_button(const Screen& screen, const PageTexts& texts, const Box& box, bool enabled) {
  const Ui& ui = screen.ui;
  const bool by_key = texts.by_enter && ui.focus.nowhere() && !ImGui::GetIO().WantTextInput &&
                      key_pressed(ImGuiKey_Enter, false);
  const bool pressed = button(ui, texts.target, box, texts.button, ButtonKind::filled, enabled);
  draw_missing(screen, texts, enabled, by_key);
  return pressed || (by_key && enabled);
}

void draw_just_ended(const Screen& screen, const Box& line) {
  const std::optional<study::LastTrial>& last = screen.session.just_ended();
  if (!last) return;
  const bool success = last->outcome == study::TrialOutcome::success;
  if (!success && last->outcome != study::TrialOutcome::timeout) return;
  const bool practice =
      screen.session.plan().trials[static_cast<std::size_t>(last->trial)].practice;
  const std::string key = std::string(practice ? "practice." : "trial.");
  const Ui& ui = screen.ui;
  fill({line.x, line.y, ui.layout.size(6), line.height},
       success ? ui.look.palette.target : ui.look.palette.quiet);
  draw_text(ui.look.fonts.reading,
            {line.x + ui.layout.size(20), line.y, line.width - ui.layout.size(20), line.height},
            ui.look.palette.text, screen.texts(key + (success ? "matched" : "time_up")));
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
