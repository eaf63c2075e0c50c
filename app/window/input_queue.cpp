#include "app/window/input_queue.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <array>
#include <utility>

namespace promenade::app {
namespace {

struct KeyName {
  int glfw;
  ImGuiKey imgui;
};

constexpr std::array<KeyName, 20> keys = {{{GLFW_KEY_TAB, ImGuiKey_Tab},
                                           {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
                                           {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
                                           {GLFW_KEY_UP, ImGuiKey_UpArrow},
                                           {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
                                           {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
                                           {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
                                           {GLFW_KEY_HOME, ImGuiKey_Home},
                                           {GLFW_KEY_END, ImGuiKey_End},
                                           {GLFW_KEY_DELETE, ImGuiKey_Delete},
                                           {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
                                           {GLFW_KEY_SPACE, ImGuiKey_Space},
                                           {GLFW_KEY_ENTER, ImGuiKey_Enter},
                                           {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
                                           {GLFW_KEY_A, ImGuiKey_A},
                                           {GLFW_KEY_C, ImGuiKey_C},
                                           {GLFW_KEY_V, ImGuiKey_V},
                                           {GLFW_KEY_X, ImGuiKey_X},
                                           {GLFW_KEY_Y, ImGuiKey_Y},
                                           {GLFW_KEY_Z, ImGuiKey_Z}}};

static_assert(experimenter_chord ==
              std::array<int, 3>{GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_E});

// Either of the two keys of a kind counts.
void set_modifiers(ImGuiIO& io, const UiEvent& event) {
  if (event.code == GLFW_KEY_LEFT_CONTROL || event.code == GLFW_KEY_RIGHT_CONTROL) {
    io.KeyCtrl = event.down;
  }
  if (event.code == GLFW_KEY_LEFT_SHIFT || event.code == GLFW_KEY_RIGHT_SHIFT) {
    io.KeyShift = event.down;
  }
}

void set_key([[maybe_unused]] ImGuiIO& io, const UiEvent& event) {
#if IMGUI_VERSION_NUM >= 18700
  for (const KeyName& key : keys) {
    if (key.glfw == event.code) io.AddKeyEvent(key.imgui, event.down);
  }
#else
  if (event.code >= 0 && event.code < static_cast<int>(std::size(io.KeysDown))) {
    io.KeysDown[event.code] = event.down;
  }
#endif
}

}  // namespace

void InputQueue::set_up([[maybe_unused]] ImGuiIO& io) {
#if IMGUI_VERSION_NUM < 18700
  for (const KeyName& key : keys) io.KeyMap[key.imgui] = key.glfw;
#endif
}

bool InputQueue::hand_over(const UiEvent& event, ImGuiIO& io) {
  switch (event.kind) {
    case UiEvent::Kind::move:
      x_ = event.x;
      y_ = event.y;
      io.MousePos = ImVec2(static_cast<float>(x_), static_cast<float>(y_));
      return false;
    case UiEvent::Kind::button:
      if (event.code < 0 || event.code > 4) return false;
      io.MouseDown[event.code] = event.down;
      if (event.down) presses_.push_back({event.t_us, event.uncertainty_us, x_, y_});
      return true;
    case UiEvent::Kind::wheel:
      io.MouseWheel += static_cast<float>(event.y);
      return false;
    case UiEvent::Kind::key:
      set_key(io, event);
      set_modifiers(io, event);
      chord_ = event.down && event.code == experimenter_chord.back() && io.KeyCtrl && io.KeyShift;
      return true;
    case UiEvent::Kind::character:
      io.AddInputCharacter(static_cast<unsigned int>(event.code));
      return false;
    case UiEvent::Kind::focus:
      // What was held is released elsewhere.
      if (!event.down) {
        std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
        io.KeyCtrl = io.KeyShift = false;
      }
      return true;
  }
  return false;
}

void InputQueue::forget_presses() {
  std::erase_if(waiting_, [](const UiEvent& event) {
    return event.kind != UiEvent::Kind::move && event.kind != UiEvent::Kind::focus;
  });
}

std::optional<UiEvent> InputQueue::take() {
  if (waiting_.empty()) return std::nullopt;
  const UiEvent event = waiting_.front();
  waiting_.pop_front();
  return event;
}

void InputQueue::feed(ImGuiIO& io) {
  presses_.clear();
  chord_ = false;
  bool enough = false;
  while (!waiting_.empty() && !enough) {
    const UiEvent event = waiting_.front();
    waiting_.pop_front();
    // What the screen does in a frame was caused by the last event in it.
    t_us_ = event.t_us;
    uncertainty_us_ = event.uncertainty_us;
    enough = hand_over(event, io);
  }
}

}  // namespace promenade::app
