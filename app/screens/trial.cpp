// The trial. Nothing outside the panel depends on the interface, to the pixel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

void draw_countdown(const Screen& screen, double left_s, double limit_s) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  const auto seconds = static_cast<int>(std::ceil(left_s));
  draw_text(ui.look.fonts.text, ui.layout.box(1120, 0, 96, 56), palette.text,
            fmt::format("{}:{:02}", seconds / 60, seconds % 60), Align::right);
  const Box box = ui.layout.box(1228, 10, 36, 36);
  const ImVec2 centre(box.middle_x(), box.middle_y());
  const float thickness = ui.layout.size(5);
  const float radius = 0.5f * (box.width - thickness);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircle(centre, radius, packed(palette.track), 48, thickness);
  const float top = -0.5f * std::numbers::pi_v<float>;
  const auto share = static_cast<float>(std::clamp(left_s / limit_s, 0.0, 1.0));
  list->PathArcTo(centre, radius, top, top + 2 * std::numbers::pi_v<float> * share, 48);
  list->PathStroke(packed(left_s <= 10 ? palette.pilot : palette.quiet), 0, thickness);
}

// How many of the questions about this motion have an answer, 0 to 1.
float share_answered(const Screen& screen) {
  const std::vector<study::ItemAnswer>& answers = screen.session.answers();
  const auto given = std::count_if(answers.begin(), answers.end(),
                                   [](const study::ItemAnswer& one) { return one.given(); });
  return answers.empty() ? 0 : static_cast<float>(given) / static_cast<float>(answers.size());
}

// "Motion 3 of 10", with a thin bar of what is done.
void draw_progress(const Screen& screen) {
  const Ui& ui = screen.ui;
  const auto [number, count] = place_of(screen, true);
  draw_text(ui.look.fonts.text, ui.layout.box(16, 4, 240, 40), ui.look.palette.quiet,
            screen.texts.with("trial.motion", {{"number", std::to_string(number)},
                                               {"count", std::to_string(count)}}));
  const Box bar = ui.layout.box(16, 44, 184, 4);
  const float share =
      (static_cast<float>(number - 1) + share_answered(screen)) / static_cast<float>(count);
  fill(bar, ui.look.palette.track);
  fill({bar.x, bar.y, std::round(share * bar.width), bar.height}, ui.look.palette.quiet);
}

void draw_strip(const Screen& screen, const study::TrialState& trial) {
  const Ui& ui = screen.ui;
  if (planned_trial(screen).interface < 0 && !planned_trial(screen).practice) {
    draw_progress(screen);
  } else {
    draw_text(ui.look.fonts.text, ui.layout.box(16, 0, 240, 56), ui.look.palette.quiet,
              number_of(screen));
  }
  const std::string title = ask(screen, "trial");
  const Box middle = ui.layout.box(200, 0, 880, 56);
  const bool fits = text_width(ui.look.fonts.title, title) <= middle.width;
  draw_text(fits ? ui.look.fonts.title : ui.look.fonts.text, middle, ui.look.palette.text, title,
            Align::centre);
  const std::optional<double>& limit = task_of(screen).limit_s;
  if (!limit) return;
  const double passed =
      1e-6 * static_cast<double>(trial.control_us(screen.now_us) - trial.started_us);
  draw_countdown(screen, std::max(0.0, *limit - passed), *limit);
}

void draw_panel(const Screen& screen, const study::TrialState& trial) {
  const Box box = screen.ui.layout.panel();
  const study::InterfaceType* type = screen.registry.find(use_of(screen).type);
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("panel", {box.width, box.height}, false, ImGuiWindowFlags_NoScrollbar);
  ImGui::PushID(trial.index);
  study::InterfacePanel panel(screen.ui, box, screen.content, trial.control_us(screen.now_us),
                              screen.changes);
  type->draw(*trial.interface, panel);
  ImGui::PopID();
  ImGui::EndChild();
}

// Ctrl-Z, and Ctrl-Y or Ctrl-Shift-Z.
bool undo_key() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl && !io.KeyShift && key_pressed(ImGuiKey_Z);
}
bool redo_key() {
  const ImGuiIO& io = ImGui::GetIO();
  return io.KeyCtrl && (key_pressed(ImGuiKey_Y) || (io.KeyShift && key_pressed(ImGuiKey_Z)));
}

void draw_below_panel(const Screen& screen, const study::TrialState& trial) {
  const Ui& ui = screen.ui;
  if (button(ui, "start_over", ui.layout.start_over(), screen.texts("trial.start_over"),
             ButtonKind::quiet)) {
    screen.actions.emplace_back(study::StartOver{});
  }
  const bool typing = ImGui::GetIO().WantTextInput;
  const bool can_undo = !trial.history.undo.empty();
  const bool can_redo = !trial.history.redo.empty();
  if (icon_button(ui, "press", "undo", ui.layout.undo(), Icon::undo, can_undo) ||
      (can_undo && !typing && undo_key())) {
    screen.actions.emplace_back(study::Undo{});
  }
  if (icon_button(ui, "press", "redo", ui.layout.redo(), Icon::redo, can_redo) ||
      (can_redo && !typing && redo_key())) {
    screen.actions.emplace_back(study::Redo{});
  }
  if (!task_of(screen).has_done) return;
  if (button(ui, "done", ui.layout.done(), screen.texts("trial.done"), ButtonKind::filled)) {
    screen.actions.emplace_back(study::Done{});
  }
}

}  // namespace

void draw_trial(const Screen& screen) {
  const study::TrialState* trial = screen.session.trial();
  if (trial == nullptr) return;
  const std::pair attempt(trial->index, trial->attempt);
  if (screen.memory.camera_attempt != attempt) {
    // Every trial begins with the same view; whoever wants another turns again.
    screen.memory.camera_attempt = attempt;
    screen.memory.told = screen.stage.orbit() = Orbit{};
    screen.stage.pace() = Pace{};
  }
  draw_strip(screen, *trial);
  if (planned_trial(screen).interface < 0) {
    draw_rate(screen);
  } else {
    draw_panel(screen, *trial);
    draw_below_panel(screen, *trial);
  }
  if (task_of(screen).playback) draw_transport(screen);
  if (screen.bundle.study.display.examples == study::ExamplesWall::panel) draw_wall(screen);
  draw_stage(screen);
  draw_practice_hint(screen, *trial);
}

}  // namespace promenade::app
