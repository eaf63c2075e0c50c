// Mouse and keyboard on their way to the screen. The callbacks of the window, the
// autopilot and the tests all push here; Dear ImGui is fed from here and from
// nowhere else. Each event keeps the time at which it arrived.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

struct ImGuiIO;

namespace promenade::app {

struct UiEvent {
  enum class Kind { move, button, wheel, key, character, focus };
  Kind kind = Kind::move;
  double x = 0, y = 0;              // move: pixels of the framebuffer; wheel: notches
  int code = 0;                     // button: 0 left; key: GLFW's number; character: Unicode
  bool down = false;                // button and key: pressed; focus: gained
  std::int64_t t_us = 0;            // on the monotonic clock
  std::int64_t uncertainty_us = 0;  // how much earlier it may have happened
};

// The keys of the experimenter's panel, by GLFW's numbers: Ctrl, Shift and E together. Nobody
// presses them by accident, and no text field takes them.
inline constexpr std::array<int, 3> experimenter_chord = {341, 340, 69};

// A mouse button went down.
struct UiPress {
  std::int64_t t_us = 0, uncertainty_us = 0;
  double x = 0, y = 0;  // pixels
};

class InputQueue {
 public:
  // Sets the keys that Dear ImGui's text field needs.
  static void set_up(ImGuiIO& io);

  void push(const UiEvent& event) {
    waiting_.push_back(event);
    if (watcher_) watcher_(event);
  }
  // Is told of every event from now on, as it arrives: for measurements.
  void watch(std::function<void(const UiEvent&)> watcher) { watcher_ = std::move(watcher); }

  // What was done to buttons and keys until now goes nowhere; the pointer stays where it is.
  void forget_presses();

  // Hands events to Dear ImGui, up to and including one change of a button or a
  // key: two in one frame would be lost. Call it before ImGui::NewFrame.
  void feed(ImGuiIO& io);

  // The next event, for who reads them without Dear ImGui; nothing: all were taken.
  std::optional<UiEvent> take();

  // What the last feed handed over, for what the screen does about it.
  std::int64_t t_us() const { return t_us_; }
  std::int64_t uncertainty_us() const { return uncertainty_us_; }
  const std::vector<UiPress>& presses() const { return presses_; }

  // The time up to which everything has been handed over.
  std::int64_t settled_us(std::int64_t now_us) const {
    return waiting_.empty() ? now_us : waiting_.front().t_us;
  }
  bool empty() const { return waiting_.empty(); }
  // Was the chord pressed in what was handed over last?
  bool chord() const { return chord_; }
  double x() const { return x_; }
  double y() const { return y_; }

 private:
  bool hand_over(const UiEvent& event, ImGuiIO& io);  // true: enough for this frame

  std::deque<UiEvent> waiting_;
  std::function<void(const UiEvent&)> watcher_;
  std::vector<UiPress> presses_;
  std::int64_t t_us_ = 0, uncertainty_us_ = 0;
  double x_ = -1, y_ = -1;
  bool chord_ = false;
};

}  // namespace promenade::app
