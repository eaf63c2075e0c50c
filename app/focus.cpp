#include "app/focus.h"

namespace promenade::app {

bool key_pressed(ImGuiKey key, bool repeat) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), repeat);
}

void Focus::take(std::string_view kind, std::string_view target) {
  kind_ = kind;
  target_ = target;
  ring_ = goes_on_ = false;
}

void Focus::go_on(std::string_view kind, std::string_view target) {
  const bool ring = ring_;
  take(kind, target);
  ring_ = ring;
}

void Focus::write_in(std::string_view kind, std::string_view target) {
  take(kind, target);
  arrived_ = goes_on_ = true;
}

void Focus::begin(const WidgetMap& before) {
  arrived_ = escape_used_ = false;
  if (passes_left_ > 0) --passes_left_;
  const std::size_t count = before.size();
  if (count == 0 || !key_pressed(ImGuiKey_Tab)) return;
  const bool back = ImGui::GetIO().KeyShift;
  const std::size_t step = back ? count - 1 : 1;
  std::size_t next = back ? count - 1 : 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (on(before[i].kind, before[i].target)) next = (i + step) % count;
  }
  for (std::size_t i = 0; i < count && !before[next].stop; ++i) next = (next + step) % count;
  take(before[next].kind, before[next].target);
  ring_ = arrived_ = true;
  // A text field that was written in lets the keyboard go.
  ImGui::SetWindowFocus(nullptr);
}

}  // namespace promenade::app
