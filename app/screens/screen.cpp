#include "app/screens/screen.h"

#include <algorithm>
#include <cassert>
#include <cmath>

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
      return draw_break(screen);
    case PageKind::release:
      return draw_release(screen);
    case PageKind::thanks:
    case PageKind::declined:
      return draw_closing(screen);
  }
}

// In the row at the top right; `right`: where it ends, at 1280 x 720. Returns where it begins,
// pixels.
float corner_button(const Screen& screen, std::string_view target, const char* key, float right,
                    bool& pressed) {
  const std::string& label = screen.texts(key);
  const float width = text_width(screen.ui.look.fonts.text, label) + screen.ui.layout.size(32);
  const Box row = screen.ui.layout.box(0, 16, 1280, 40);
  pressed |= button(screen.ui, target, {right - width, row.y, width, row.height}, label,
                    ButtonKind::quiet);
  return right - width;
}

void offer_pause(const Screen& screen) {
  const PageKind kind = screen.session.page().kind;
  if (!can_pause(kind)) return;
  // A field that is written in and a list that is searched use the key first.
  const bool used = ImGui::GetIO().WantTextInput || screen.ui.focus.escape_used();
  bool wanted = !used && key_pressed(ImGuiKey_Escape, false);
  if (kind != PageKind::trial) {
    const float right = screen.ui.layout.box(1264, 0, 0, 0).x;
    const float left = corner_button(screen, "pause", "button.pause", right, wanted);
    bool leaves = false;
    if (screen.session.can_leave()) corner_button(screen, "leave", "button.leave", left, leaves);
    if (leaves) screen.actions.emplace_back(study::Leave{});
  }
  if (wanted) screen.actions.emplace_back(study::Pause{});
}

void draw_all(const Screen& screen) {
  if (screen.failure != nullptr) return draw_failure(screen);
  if (!screen.memory.offered.empty()) return draw_resume(screen);
  if (screen.session.left()) return draw_left(screen);
  if (open_experimenter(screen)) return draw_experimenter(screen);
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
         kind == PageKind::trial || kind == PageKind::questionnaire || kind == PageKind::release ||
         kind == PageKind::break_;
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

// Or in one, which loses its middle when two are not enough.
void draw_in_two_lines(const Screen& screen, const Box& box, std::string_view text) {
  ImFont* const font = screen.ui.look.fonts.bold;
  const Rgb& colour = screen.ui.look.palette.text;
  const float height = paragraphs_height(font, box.width, text);
  if (height > box.height) return draw_line(font, box, colour, text);
  draw_paragraphs(font, box.x, std::round(box.middle_y() - 0.5f * height), box.width, colour, text);
}

// Whoever presses too early reads what is missing.
void draw_missing(const Screen& screen, const PageTexts& texts, bool enabled, bool by_key) {
  bool& too_early = screen.memory.too_early;
  const bool focused = screen.ui.focus.on("press", texts.target) &&
                       (key_pressed(ImGuiKey_Enter, false) || key_pressed(ImGuiKey_Space, false));
  if (screen.fresh) too_early = false;
  screen.memory.refused = !enabled && (by_key || focused || ImGui::IsItemActivated());
  too_early = !enabled && (too_early || screen.memory.refused);
  if (!too_early || texts.missing.empty()) return;
  const bool in_column = texts.missing_at.width == 0;
  const Box box = in_column ? screen.ui.layout.box(320, 640, 424, 48) : texts.missing_at;
  draw_in_two_lines(screen, box, texts.missing);
}

}  // namespace

float draw_text_column(const Screen& screen, std::string_view title, std::string_view text) {
  const Ui& ui = screen.ui;
  const Box column = ui.layout.column();
  const float heading = ui.layout.size(56);
  draw_just_ended(screen, ui.layout.box(320, 52, 640, 36));
  const bool fits = text_width(ui.look.fonts.heading, title) <= column.width;
  draw_line(fits ? ui.look.fonts.heading : ui.look.fonts.title,
            {column.x, column.y, column.width, heading}, ui.look.palette.text, title);
  const float from = column.y + heading + ui.layout.size(16);
  return draw_long_text(screen, {column.x, from, column.width, column.bottom() - from}, text);
}

float draw_text_page(const Screen& screen, const PageTexts& texts, bool enabled, bool& pressed) {
  const float bottom = draw_text_column(screen, texts.title, texts.text);
  pressed = main_button(screen, texts, screen.ui.layout.box(760, 640, 200, 48), enabled);
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

const study::InterfaceUse& use_of(const Screen& screen) {
  const int interface = planned_trial(screen).interface;
  assert(interface >= 0 && "a rate task has no interface");
  return screen.bundle.study.interfaces[static_cast<std::size_t>(interface)];
}

// With the name of the condition where two have one title, as in questionnaires.
std::string title_of(const Screen& screen, const study::InterfaceUse& use) {
  const std::string& title = screen.texts("interface." + use.type + ".title");
  const std::vector<study::InterfaceUse>& all = screen.bundle.study.interfaces;
  const auto alike = std::count_if(all.begin(), all.end(),
                                   [&use](const auto& other) { return other.type == use.type; });
  return alike > 1 ? title + " (" + use.name + ")" : title;
}

Place place_of(const Screen& screen, bool within_task) {
  const study::PlannedTrial& here = planned_trial(screen);
  Place place;
  for (const study::PlannedTrial& trial : screen.session.plan().trials) {
    if (trial.practice || (within_task && trial.task != here.task)) continue;
    ++place.count;
    if (trial.position <= here.position) ++place.number;
  }
  return place;
}

// Practice is not numbered.
std::string number_of(const Screen& screen) {
  if (planned_trial(screen).practice) return screen.texts("trial.practice");
  const auto [number, count] = place_of(screen, false);
  return screen.texts.with("trial.number",
                           {{"number", std::to_string(number)}, {"count", std::to_string(count)}});
}

std::string ask(const Screen& screen, const std::string& prefix) {
  const study::TaskKind kind = task_of(screen).kind;
  if (kind == study::TaskKind::match) return screen.texts(prefix + ".match");
  if (kind == study::TaskKind::guess) return screen.texts(prefix + ".guess");
  if (kind == study::TaskKind::rate) return screen.texts(prefix + ".rate");
  const study::Target& target = study::target_of(screen.bundle.study, planned_trial(screen));
  return screen.texts.with(prefix + ".find",
                           {{"quality", study::text_in(target.quality, screen.language)}});
}

}  // namespace promenade::app
