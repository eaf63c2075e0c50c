// Which control the keyboard works on. Tab and Shift-Tab go through the controls of the
// page in the order in which they are drawn; Enter and Space press the control, the
// arrow keys move it. A ring shows it once the keyboard was used.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

#include "app/widget_map.h"

namespace promenade::app {

class Focus {
 public:
  // Once a frame, after ImGui::NewFrame, with the controls of the frame before.
  void begin(const WidgetMap& before);
  bool on(std::string_view kind, std::string_view target) const {
    return kind == kind_ && target == target_;
  }
  // On one whose target begins so?
  bool on_first(std::string_view kind, std::string_view beginning) const {
    return kind == kind_ && target_.rfind(beginning, 0) == 0;
  }
  // The keyboard works on nothing: Enter is the page's main button.
  bool nowhere() const { return kind_.empty(); }
  void leave() { take({}, {}); }
  // The mouse took this one; no ring.
  void take(std::string_view kind, std::string_view target);
  // A control led on to another one, by key: the ring stays.
  void go_on(std::string_view kind, std::string_view target);
  // A text field that what was typed elsewhere belongs to; its text stays.
  void write_in(std::string_view kind, std::string_view target);
  bool goes_on() const { return goes_on_; }
  bool on_kind(std::string_view kind) const { return kind == kind_; }
  // What is done takes a few passes of Dear ImGui to have its effect, and what was typed meanwhile
  // is to find it: a ToolPage draws them at once, before it takes in more.
  void settle() { passes_left_ = 4; }
  bool settling() const { return passes_left_ > 0; }
  // A control had a use for the Escape key of this frame: no pause.
  void use_escape() { escape_used_ = true; }
  bool escape_used() const { return escape_used_; }
  bool ring() const { return ring_; }
  // The keyboard came here in this frame: bring it into sight.
  bool arrived() const { return arrived_; }

 private:
  std::string kind_, target_;
  int passes_left_ = 0;
  bool ring_ = false, arrived_ = false, goes_on_ = false, escape_used_ = false;
};

// Was the key pressed, or is it held and repeats?
bool key_pressed(ImGuiKey key, bool repeat = true);

}  // namespace promenade::app
