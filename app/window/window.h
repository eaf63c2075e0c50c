// A window with an OpenGL 3.3 context. Its callbacks stamp each event on arrival
// and put it into the queue.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/window/input_queue.h"

struct GLFWwindow;

namespace promenade::app {

// Is there a display to open a window on, and is it the one that is wanted? `screen`
// counts from 1; 0: the first one. Opens none. Throws OutsideError with what to do when
// there is not.
void require_display(int screen = 0);
// "1: DP-1, 1920 x 1080" and so on. Throws OutsideError without a display.
std::vector<std::string> display_names();
// A display beside that one, from 1; throws OutsideError when there is only one.
int another_display(int screen);

struct WindowOptions {
  std::string title = "Promenade";
  bool windowed = false;           // instead of the whole screen
  int screen = 0;                  // which one, from 1; 0: the first
  bool shows_only = false;         // takes neither mouse nor keyboard
  bool hidden = false;             // only for its context: see OffScreen
  int width = 1280, height = 720;  // of a windowed one
};

class Window {
 public:
  // Throws OutsideError. The queue outlives the window.
  Window(const WindowOptions& options, InputQueue& queue);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void poll();                       // takes in what has arrived
  void wait_events(double seconds);  // the same, but first waits for something
  void swap();
  // From now on each stretch in which nobody asked for events is noted here, microseconds;
  // null: no longer.
  void note_gaps(std::vector<std::int64_t>* gaps_us) { gaps_us_ = gaps_us; }
  // Files and folders that were dropped on it since this was last asked.
  std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }
  void use();            // what is drawn now goes to this window
  bool closing() const;  // the person closed it
  void close();
  void stay();                          // it is not closing after all
  int width() const { return width_; }  // pixels of the framebuffer
  int height() const { return height_; }
  double refresh_hz() const { return refresh_hz_; }  // 0: not known
  float content_scale() const { return content_scale_; }
  std::string description() const;  // JSON: display, driver, scale

 private:
  struct Callbacks;
  void stamp(UiEvent event);
  void measure();
  void note_gap() const;

  GLFWwindow* handle_ = nullptr;
  InputQueue& queue_;
  std::int64_t last_poll_us_ = 0;
  std::vector<std::string> dropped_;
  std::vector<std::int64_t>* gaps_us_ = nullptr;
  int width_ = 0, height_ = 0;
  double pixels_per_unit_ = 1;  // framebuffer pixels in a unit of the window system
  double refresh_hz_ = 0;
  float content_scale_ = 1;
};

}  // namespace promenade::app
