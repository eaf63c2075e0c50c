// What can be done on the stage: the camera, and where the task allows it the pace of
// the walk. The same for every interface.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/screens/screen.h"

namespace promenade::app {
namespace {

constexpr float nearest = 2.5f, farthest = 0.7f;  // zoom
constexpr float widest = 1.5f;                    // metres that the picture can be moved
constexpr float lowest_pitch = -start_pitch + 0.02f,
                highest_pitch = 1.2f;  // radians from the start

void turn_with_mouse(const Screen& screen, Orbit& orbit) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  orbit.yaw += 0.008f * moved.x / screen.ui.layout.scale;
  orbit.pitch = std::clamp(orbit.pitch + 0.006f * moved.y / screen.ui.layout.scale, lowest_pitch,
                           highest_pitch);
}

void move_with_mouse(const Screen& screen, Orbit& orbit) {
  const ImVec2 moved = ImGui::GetIO().MouseDelta;
  // One metre is as long as the figure's picture says.
  const float metre = screen.stage_plan.figure_height / 1.75f * orbit.zoom;
  orbit.right = std::clamp(orbit.right + moved.x / metre, -widest, widest);
  orbit.up = std::clamp(orbit.up - moved.y / metre, -widest, widest);
}

// The arrow keys turn, with Shift they move.
void move_with_keys(Orbit& orbit) {
  const auto steps = [](ImGuiKey less, ImGuiKey more) {
    return static_cast<float>(key_pressed(more)) - static_cast<float>(key_pressed(less));
  };
  const float right = steps(ImGuiKey_LeftArrow, ImGuiKey_RightArrow);
  const float up = steps(ImGuiKey_DownArrow, ImGuiKey_UpArrow);
  if (ImGui::GetIO().KeyShift) {
    orbit.right = std::clamp(orbit.right + 0.05f * right, -widest, widest);
    orbit.up = std::clamp(orbit.up + 0.05f * up, -widest, widest);
  } else {
    orbit.yaw += 0.1f * right;
    orbit.pitch = std::clamp(orbit.pitch + 0.06f * up, lowest_pitch, highest_pitch);
  }
  if (key_pressed(ImGuiKey_PageUp)) orbit.zoom = std::min(1.1f * orbit.zoom, nearest);
  if (key_pressed(ImGuiKey_PageDown)) orbit.zoom = std::max(orbit.zoom / 1.1f, farthest);
}

void use_mouse(const Screen& screen, Orbit& orbit) {
  const Box& stage = screen.stage_plan.figures;
  ImGui::SetCursorScreenPos({stage.x, stage.y});
  ImGui::InvisibleButton("stage", {stage.width, stage.height},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  const ImGuiIO& io = ImGui::GetIO();
  if (place(screen.ui, "stage", "stage", stage)) move_with_keys(orbit);
  if (ImGui::IsItemActive()) {
    const bool turns = ImGui::IsMouseDown(0) && !io.KeyShift;
    turns ? turn_with_mouse(screen, orbit) : move_with_mouse(screen, orbit);
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    orbit.zoom = std::clamp(orbit.zoom * std::pow(1.1f, io.MouseWheel), farthest, nearest);
  }
}

void tell_camera(const Screen& screen, const Orbit& orbit) {
  const Orbit told = screen.memory.told.value_or(Orbit{});
  if (told == orbit) return;
  screen.memory.told = orbit;
  screen.actions.emplace_back(
      study::Camera{orbit.yaw, orbit.pitch, orbit.zoom, orbit.right, orbit.up});
}

void draw_plate(const Screen& screen, Role role) {
  const Ui& ui = screen.ui;
  const Palette& palette = ui.look.palette;
  const bool rated = task_of(screen).kind == study::TaskKind::rate;
  const std::string& text =
      screen.texts(role == Role::target      ? rated ? "trial.rated" : "trial.target"
                   : role == Role::reference ? "trial.reference"
                                             : "trial.yours");
  const Eigen::Vector2f at = screen.stage.plate(screen.stage_plan, role);
  const float width = std::round(text_width(ui.look.fonts.bold, text) + ui.layout.size(28));
  const Box plate{std::round(at.x() - 0.5f * width), at.y(), width, ui.layout.size(30)};
  fill(plate, colour_of(palette, role));
  draw_text(ui.look.fonts.bold, plate, ink_on(palette, colour_of(palette, role)), text,
            Align::centre);
  if (!screen.stage.hides(role)) return;
  // Where the figure would stand.
  const float width_of_hint = ui.layout.size(380);
  const Box hint{std::round(at.x() - 0.5f * width_of_hint), screen.stage_plan.foot_y - plate.height,
                 width_of_hint, 2 * plate.height};
  draw_text(ui.look.fonts.text, hint, palette.quiet, screen.texts("trial.hidden"), Align::centre);
}

}  // namespace

void draw_stage(const Screen& screen) {
  const Ui& ui = screen.ui;
  Orbit& orbit = screen.stage.orbit();
  // The button lies on the stage: it is asked first.
  const StagePlan& plan = screen.stage_plan;
  const std::string& reset = screen.texts("trial.reset_view");
  const float width = text_width(ui.look.fonts.text, reset) + ui.layout.size(24);
  const Box corner{plan.figures.x, plan.figures.y, std::round(width), ui.layout.size(36)};
  if (orbit != Orbit{} && button(ui, "reset_view", corner, reset, ButtonKind::quiet)) {
    orbit = {};
  }
  use_mouse(screen, orbit);
  tell_camera(screen, orbit);
  for (const Role role : roles) {
    if (screen.stage.shows(role)) draw_plate(screen, role);
  }
}

namespace {

void tell_pace(const Screen& screen, double phase = -1) {
  const Pace& pace = screen.stage.pace();
  screen.actions.emplace_back(study::Playback{pace.playing, pace.speed, phase});
}

// Full speed, half and a quarter, by turns.
double slower(double speed) { return speed > 0.9 ? 0.5 : speed > 0.4 ? 0.25 : 1; }

}  // namespace

void draw_transport(const Screen& screen) {
  const Ui& ui = screen.ui;
  const Box& row = screen.stage_plan.transport;
  Pace& pace = screen.stage.pace();
  const float side = row.height;
  const Box play{row.x + ui.layout.size(8), row.y, side, side};
  if (icon_button(ui, "press", "play", play, pace.playing ? Icon::pause : Icon::play)) {
    pace.playing = !pace.playing;
    tell_pace(screen);
  }
  const Box speed{play.right() + ui.layout.size(4), row.y, ui.layout.size(64), side};
  const char* factor = pace.speed > 0.9 ? "1 ×" : pace.speed > 0.4 ? "½ ×" : "¼ ×";
  if (small_button(ui, "press", "speed", speed, factor)) {
    pace.speed = slower(pace.speed);
    tell_pace(screen);
  }
  const float from = speed.right() + ui.layout.size(8);
  const Box scrub{from, row.y, row.right() - from - ui.layout.size(8), side};
  if (const auto phase = slider(ui, "scrub", "walk", scrub, screen.stage.phase(), 0)) {
    pace.playing = false;
    screen.stage.scrub(*phase);
    tell_pace(screen, *phase);
  }
}

}  // namespace promenade::app
