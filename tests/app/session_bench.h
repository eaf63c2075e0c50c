// A whole session on the real pages, without a window: time is a number, the
// pointer is the autopilot's.
#pragma once

#include <filesystem>

#include "app/autopilot.h"
#include "app/registry.h"
#include "app/session_view.h"
#include "study/load_study.h"

namespace promenade::app::bench {

class SessionBench {
 public:
  using Roster = decltype(ViewOptions::ask_roster);
  // Without a language the first page asks; without a study it is the demo.
  explicit SessionBench(const std::string& language = "en", std::uint64_t seed = 1,
                        const std::string& study_text = "", const Roster& roster = {});
  ~SessionBench();

  void frame();  // 1/60 s
  void walk();   // the same, and the figures walk on
  // Lets the autopilot work until the session is over or `done` says so. False: it
  // took more than `minutes`.
  bool play(
      double minutes, const std::function<bool()>& done = [] { return false; });
  void click(const std::string& target);  // a button, with the mouse
  void click_on(const std::string& kind, const std::string& target);
  void key(int glfw_key);
  void chord();  // the keys of the experimenter's panel

  const study::Session& session() const { return live_.session(); }
  SessionView& view() { return view_; }
  const SessionView& view() const { return view_; }
  InputQueue& queue() { return queue_; }
  const std::filesystem::path& file() const { return file_; }
  std::int64_t session_us() const { return live_.since_began(now_us_); }
  void stop(study::Actor actor = study::Actor::participant) { view_.stop("test", now_us_, actor); }
  void type(const std::string& text);
  void hold(int glfw_key, bool down);  // a key that others are pressed with
  void wheel(double notches);
  void click_fast(int times);  // on the stage, all before the next frame
  void show_late();            // a frame that took a tenth of a second
  // A watcher asks for it and waits until it was read; returns the request as it was written.
  study::Request ask(study::Request request);
  void close_window() { view_.ask_to_close(now_us_); }

 private:
  std::int64_t now_us_ = 1'000'000;  // first: the session begins at it
  std::filesystem::path file_;
  study::StudyBundle bundle_;
  study::Store store_;
  study::RequestReader requests_{file_.string()};
  Gui gui_;
  InputQueue queue_;
  LiveSession live_;
  SessionView view_;
  Autopilot autopilot_;
};

}  // namespace promenade::app::bench
