#include "app/screens/screen.h"

#include <algorithm>
#include <cmath>

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
  const Box box = ui.layout.box(24, 680, 640, 24);
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

void orbit_with_mouse(const Screen& screen) {
  const Box stage = screen.ui.layout.stage();
  Orbit& orbit = screen.stage.orbit();
  ImGui::SetCursorScreenPos({stage.x, stage.y});
  ImGui::InvisibleButton("stage", {stage.width, stage.height});
  Widget widget;
  widget.box = stage;
  widget.view = stage;
  screen.ui.widgets.add("stage", "stage", widget);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActive()) {
    orbit.yaw += 0.008f * io.MouseDelta.x / screen.ui.layout.scale;
    orbit.pitch = std::clamp(orbit.pitch + 0.006f * io.MouseDelta.y / screen.ui.layout.scale,
                             -start_pitch + 0.02f, 1.2f);
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    orbit.zoom = std::clamp(orbit.zoom * std::pow(1.1f, io.MouseWheel), 0.7f, 2.5f);
  }
  const Orbit told = screen.memory.told.value_or(Orbit{});
  if (told.yaw == orbit.yaw && told.pitch == orbit.pitch && told.zoom == orbit.zoom) return;
  screen.memory.told = orbit;
  screen.actions.emplace_back(study::Camera{orbit.yaw, orbit.pitch, orbit.zoom});
}

void draw_plates(const Screen& screen) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  for (const Role role : {Role::target, Role::created}) {
    if (!screen.stage.shows(role)) continue;
    const bool target = role == Role::target;
    const std::string& text = screen.texts(target ? "trial.target" : "trial.yours");
    const Eigen::Vector2f at = screen.stage.plate(ui.layout, role);
    const float width = std::round(text_width(ui.look.fonts.bold, text) + ui.layout.size(28));
    const Box plate{std::round(at.x() - 0.5f * width), at.y(), width, ui.layout.size(30)};
    fill(plate, target ? palette.target : palette.created);
    // Black on the light green, white on the dark blue: both can be read.
    draw_text(ui.look.fonts.bold, plate, target ? palette.text : palette.on_colour, text,
              Align::centre);
  }
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
