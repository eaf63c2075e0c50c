#include "tests/app/session_bench.h"

#include <unistd.h>

#include "study/identity.h"

namespace promenade::app::bench {
namespace {

std::filesystem::path fresh_file() {
  static int number = 0;
  return std::filesystem::temp_directory_path() /
         ("promenade_app_" + std::to_string(getpid()) + "_" + std::to_string(number++) + ".db");
}

study::SessionHeader header_of(const std::string& language) {
  study::SessionHeader header;
  header.language = language.empty() ? "en" : language;
  header.simulated = true;
  return header;
}

study::StudyBundle bundle_of(const std::string& text) {
  if (text.empty()) return study::load_study("configs/demo.toml", interfaces());
  return study::read_study("test.toml", text, interfaces(), study::load_motion_set);
}

}  // namespace

SessionBench::SessionBench(const std::string& language, std::uint64_t seed,
                           const std::string& study_text, const Roster& roster)
    : file_(fresh_file()),
      bundle_(bundle_of(study_text)),
      store_(file_, bundle_),
      gui_(make_palette(false), shown_words(bundle_)),
      live_(study::Session(bundle_, interfaces(),
                           study::make_plan(bundle_.study, static_cast<int>(seed % 2)),
                           language.empty()),
            store_, header_of(language), now_us_),
      view_((gui_.fit(1280, 720), bundle_), interfaces(), gui_, live_, queue_,
            {language, "", false, true, {}, roster, &requests_}),
      autopilot_(study::SimulatedParticipant(bundle_, interfaces(), seed), "S001") {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
}

SessionBench::~SessionBench() {
  for (const char* end : {"", "-wal", "-shm", ".control"})
    std::filesystem::remove(file_.string() + end);
}

void SessionBench::walk() {
  view_.advance(now_us_);
  frame();
}

void SessionBench::frame() {
  constexpr std::int64_t frame_us = 16'667;
  now_us_ += frame_us;
  gui_.use();  // a test may have another one
  view_.frame(now_us_);
  view_.shown({.shown_us = now_us_ + 8000, .interval_us = frame_us, .work_us = 8000});
}

bool SessionBench::play(double minutes, const std::function<bool()>& done) {
  const auto frames = static_cast<int>(minutes * 3600);
  for (int k = 0; k < frames; ++k) {
    if (view_.ended() || done()) return true;
    autopilot_.act(now_us_, session(), view_.widgets(), queue_);
    frame();
  }
  return false;
}

void SessionBench::click(const std::string& target) { click_on("press", target); }

void SessionBench::click_on(const std::string& kind, const std::string& target) {
  frame();
  frame();
  const Widget* widget = view_.widgets().find(kind, target);
  if (widget == nullptr) throw std::logic_error("there is no " + kind + " " + target);
  queue_.push({.kind = UiEvent::Kind::move,
               .x = widget->box.middle_x(),
               .y = widget->box.middle_y(),
               .t_us = now_us_});
  for (const bool down : {true, false}) {
    queue_.push({.kind = UiEvent::Kind::button, .code = 0, .down = down, .t_us = now_us_});
    frame();
  }
  frame();
}

void SessionBench::key(int glfw_key) {
  for (const bool down : {true, false}) {
    queue_.push({.kind = UiEvent::Kind::key, .code = glfw_key, .down = down, .t_us = now_us_});
    frame();
  }
  frame();
}

void SessionBench::chord() {
  for (const bool down : {true, false}) {
    for (const int key : experimenter_chord) hold(key, down);
  }
  frame();
}

void SessionBench::type(const std::string& text) {
  frame();
  frame();
  for (const char letter : text) {
    queue_.push({.kind = UiEvent::Kind::character, .code = letter, .t_us = now_us_});
  }
  frame();
  frame();
}

void SessionBench::hold(int glfw_key, bool down) {
  queue_.push({.kind = UiEvent::Kind::key, .code = glfw_key, .down = down, .t_us = now_us_});
  frame();
}

void SessionBench::click_fast(int times) {
  const Widget* stage = view_.widgets().find("stage", "stage");
  if (stage == nullptr) throw std::logic_error("there is no stage");
  queue_.push({.kind = UiEvent::Kind::move,
               .x = stage->box.middle_x(),
               .y = stage->box.middle_y(),
               .t_us = now_us_});
  for (int k = 0; k < 2 * times; ++k) {
    queue_.push(
        {.kind = UiEvent::Kind::button, .code = 0, .down = k % 2 == 0, .t_us = now_us_ + k});
  }
}

void SessionBench::show_late() {
  now_us_ += 100'000;
  view_.shown({.shown_us = now_us_, .interval_us = 100'000, .work_us = 99'000, .late_us = 83'333});
}

study::Request SessionBench::ask(study::Request request) {
  if (request.id.empty()) request.id = study::random_uuid();
  request.session = store_.session();
  request.written_utc = study::utc_now();
  study::ask(file_.string(), request);
  constexpr int frames = 15;  // a quarter of a second
  for (int k = 0; k < frames; ++k) frame();
  return request;
}

void SessionBench::wheel(double notches) {
  queue_.push({.kind = UiEvent::Kind::wheel, .y = notches, .t_us = now_us_});
  frame();
  frame();
}

}  // namespace promenade::app::bench
