// A session in a real window, with a clock of its own: nothing waits.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/gui.h"
#include "app/session_view.h"
#include "app/window/gui_renderer.h"
#include "app/window/window.h"
#include "tests/screenshots/album.h"

namespace promenade::app::screenshots {

// What every studio works with, and where it is.
struct Room {
  Window& window;
  FigureRenderer& renderer;
  InputQueue& queue;
  std::filesystem::path folder;  // for the databases
};

class Studio {
 public:
  // Both outlive it. The session has no code yet. The log of a simulated one waits for no disk.
  Studio(Room& room, const study::StudyBundle& bundle, const ViewOptions& options,
         bool simulated = true);
  ~Studio();

  void pass(double seconds);  // lets time pass, in frames that nobody sees
  void press_key(int glfw_key);
  void press_letter(char letter);
  void press_chord();             // of the experimenter's panel
  void take(StudyAction action);  // by the participant, now
  void begin_as(const std::string& code);
  void occupy(const std::string& code);  // by an earlier session of a person
  // A few likely things with the controls of the running trial.
  void play(int inputs);
  Photograph shoot();
  // Draws a frame and brings it to the screen; how long that took, microseconds.
  std::int64_t time_frame();

  const study::StudyBundle& bundle() const { return bundle_; }
  const study::Session& session() const { return live_.session(); }
  SessionView& view() { return view_; }
  const study::PlannedTrial& planned() const;  // of the page

 private:
  void frame(std::int64_t passed_us);
  void draw();

  Room& room_;
  const study::StudyBundle& bundle_;
  std::filesystem::path file_;
  std::int64_t now_us_ = 1'000'000;
  study::Store store_;
  Gui gui_;
  std::unique_ptr<GuiRenderer> gui_renderer_;
  LiveSession live_;
  SessionView view_;
  study::Rng rng_{1, 1, "screenshots"};
};

}  // namespace promenade::app::screenshots
