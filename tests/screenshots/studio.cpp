#include "tests/screenshots/studio.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "app/registry.h"
#include "app/window/clock.h"

namespace promenade::app::screenshots {
namespace {

constexpr std::int64_t frame_us = 16'667;

std::filesystem::path fresh_file(const std::filesystem::path& folder) {
  static int number = 0;
  return folder / (std::to_string(number++) + ".db");
}

study::SessionHeader header_of(const ViewOptions& options, bool simulated) {
  study::SessionHeader header;
  header.language = options.language.empty() ? "en" : options.language;
  header.simulated = simulated;
  return header;
}

}  // namespace

Studio::Studio(Room& room, const study::StudyBundle& bundle, const ViewOptions& options,
               bool simulated)
    : room_(room),
      bundle_(bundle),
      file_(fresh_file(room.folder)),
      store_(file_, bundle),
      gui_(make_palette(bundle.study.display.paper_colours), shown_words(bundle)),
      live_(study::Session(bundle, interfaces(), study::make_plan(bundle.study, 0),
                           options.language.empty()),
            store_, header_of(options, simulated), now_us_),
      view_(
          (gui_.fit(room.window.width(), room.window.height(), bundle.study.display.scale), bundle),
          interfaces(), gui_, live_, room.queue, options) {
  gui_renderer_ = std::make_unique<GuiRenderer>();
  gui_renderer_->upload_fonts();
  // A pointer that rests on nothing.
  room_.queue.push({.kind = UiEvent::Kind::move, .x = -1, .y = -1});
}

Studio::~Studio() {
  gui_renderer_.reset();  // while there is a context of Dear ImGui
}

const study::PlannedTrial& Studio::planned() const {
  return session().plan().trials[static_cast<std::size_t>(session().page().trial)];
}

void Studio::frame(std::int64_t passed_us) {
  now_us_ += passed_us;
  view_.advance(now_us_);
  view_.frame(now_us_);
  view_.shown({.shown_us = now_us_ + 8000});
}

void Studio::pass(double seconds) {
  auto left_us = static_cast<std::int64_t>(1e6 * seconds);
  for (; left_us > 0 && !view_.ended(); left_us -= 10 * frame_us) {
    frame(std::min(left_us, 10 * frame_us));
  }
}

void Studio::press_key(int glfw_key) {
  for (const bool down : {true, false}) {
    room_.queue.push({.kind = UiEvent::Kind::key, .code = glfw_key, .down = down, .t_us = now_us_});
    frame(frame_us);
  }
}

void Studio::press_letter(char letter) {
  room_.queue.push({.kind = UiEvent::Kind::character, .code = letter, .t_us = now_us_});
  frame(frame_us);
}

void Studio::press_chord() {
  for (const bool down : {true, false}) {
    for (const int key : experimenter_chord) {
      room_.queue.push({.kind = UiEvent::Kind::key, .code = key, .down = down, .t_us = now_us_});
      frame(frame_us);
    }
  }
}

void Studio::take(StudyAction action) {
  live_.take(std::move(action), {.t_us = now_us_, .frame_us = now_us_});
  frame(frame_us);
}

void Studio::occupy(const std::string& code) {
  study::Store other(file_, bundle_);
  study::SessionHeader header = header_of({}, false);
  header.participant = code;
  other.begin_session(header, study::make_plan(bundle_.study, 1));
  other.end_session("2020-01-01T00:00:00Z");
}

void Studio::begin_as(const std::string& code) {
  live_.record_as(code, true);
  take(study::Continue{});
}

void Studio::play(int inputs) {
  if (session().trial() == nullptr || planned().interface < 0) return;
  const study::InterfaceUse& use =
      bundle_.study.interfaces[static_cast<std::size_t>(planned().interface)];
  const study::InterfaceType& type = *interfaces().find(use.type);
  for (int k = 0; k < inputs && session().trial() != nullptr; ++k) {
    pass(0.7);
    if (session().trial() == nullptr) return;  // it was won, or its time was up
    const auto ideas = type.simulate(*session().trial()->interface, rng_);
    if (!ideas.empty()) take(study::Control{ideas[rng_.below(ideas.size())]});
  }
}

void Studio::draw() {
  now_us_ += frame_us;
  const Window& window = room_.window;
  view_.advance(now_us_);
  room_.renderer.begin(window.width(), window.height(), gui_.look().palette.background);
  view_.draw_figures(room_.renderer);
  view_.frame(now_us_);
  gui_renderer_->draw();
}

Photograph Studio::shoot() {
  // The first frame of a page asks for the small figures that the second one shows.
  frame(frame_us);
  draw();
  return photograph(room_.window.width(), room_.window.height());
}

std::int64_t Studio::time_frame() {
  const std::int64_t before = monotonic_us();
  draw();
  glFinish();
  room_.window.swap();
  return monotonic_us() - before;
}

}  // namespace promenade::app::screenshots
