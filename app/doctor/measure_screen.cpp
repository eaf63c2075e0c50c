#include "app/doctor/measure_screen.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "app/box.h"
#include "app/stage.h"
#include "app/widgets.h"
#include "app/window/clock.h"
#include "app/window/frame_loop.h"
#include "study/interface.h"

namespace promenade::app {
namespace {

constexpr double usual_hz = 60;
constexpr std::size_t first_frames = 8;  // compile shaders, and find the beat

class Walkers {
 public:
  Walkers(const Canvas& canvas, const study::StudyBundle& bundle, const char* caption)
      : canvas_(canvas),
        caption_(caption),
        stage_(bundle.space.set, bundle.bank),
        average_(motion::blend(bundle.space, study::start_weights(bundle.space))) {}

  void draw_figures(std::int64_t now_us) {
    const Layout& layout = canvas_.gui.layout();
    const Palette& palette = canvas_.gui.look().palette;
    stage_.advance(now_us, {.target = &average_, .created = &average_});
    canvas_.renderer.begin(canvas_.window.width(), canvas_.window.height(), palette.background);
    stage_.draw(canvas_.renderer, layout, layout.stage_plan(false), palette);
    canvas_.renderer.fill(layout.panel(), palette.panel);
  }

  void draw_caption() {
    const Look& look = canvas_.gui.look();
    ImGui::GetIO().DeltaTime = 1.0f / static_cast<float>(usual_hz);
    ImGui::NewFrame();
    const Box box = canvas_.gui.layout().strip();
    ImGui::GetForegroundDrawList()->AddText(look.fonts.title, look.fonts.title->FontSize,
                                            {box.x + canvas_.gui.layout().size(16), box.y},
                                            packed(look.palette.text), caption_);
    ImGui::Render();
    canvas_.gui_renderer.draw();
  }

 private:
  const Canvas& canvas_;
  const char* caption_;
  Stage stage_;
  motion::Cycle average_;
};

std::vector<std::int64_t> show(const Canvas& canvas, Walkers& walkers, const ScreenTest& test) {
  std::size_t shown = 0;
  const std::int64_t end_us = monotonic_us() + static_cast<std::int64_t>(1e6 * test.longest_s);
  const FrameHooks hooks{.draw_figures = [&](std::int64_t now_us) { walkers.draw_figures(now_us); },
                         .draw_screen = [&](std::int64_t) { walkers.draw_caption(); },
                         .shown = [&](const ShownFrame&) { ++shown; },
                         .ended =
                             [&] {
                               return shown > test.frames || monotonic_us() > end_us ||
                                      (test.stopped && test.stopped());
                             }};
  return run_frames(canvas.window, hooks, usual_hz).interval_us;
}

}  // namespace

DisplayFinding describe_display(const Window& window) {
  const auto words = nlohmann::json::parse(window.description());
  return {.width = window.width(),
          .height = window.height(),
          .refresh_hz = window.refresh_hz(),
          .scale = window.content_scale(),
          .renderer = words["renderer"],
          .opengl = words["opengl"]};
}

void measure_screen(const Canvas& canvas, const study::StudyBundle& bundle, const ScreenTest& test,
                    Findings& findings) {
  Walkers walkers(canvas, bundle, test.caption);
  ScreenTest first = test;
  first.frames = first_frames;
  first.longest_s = 0.3;
  show(canvas, walkers, first);
  let_renderer_threads_idle();
  InputFinding input;
  const std::int64_t began_us = monotonic_us();
  canvas.window.note_gaps(&input.gap_us);
  PacingFinding pacing{.interval_us = show(canvas, walkers, test)};
  canvas.window.note_gaps(nullptr);
  input.watched_us = monotonic_us() - began_us;
  if (canvas.window.refresh_hz() > 0) pacing.wanted_hz = canvas.window.refresh_hz();
  findings.pacing = std::move(pacing);
  findings.input = std::move(input);
}

}  // namespace promenade::app
