// The part of a page that scrolls when it has more than there is room for.
#include "app/screens/screen.h"

namespace promenade::app {
namespace {

void scroll_by_keys(const Screen& screen, const Box& box) {
  const Focus& focus = screen.ui.focus;
  if (ImGui::GetIO().WantTextInput || focus.on_kind("stage")) return;
  const auto scroll = [](float by) { ImGui::SetScrollY(ImGui::GetScrollY() + by); };
  const float line = screen.ui.layout.size(40);
  if (key_pressed(ImGuiKey_DownArrow)) scroll(line);
  if (key_pressed(ImGuiKey_UpArrow)) scroll(-line);
  if (key_pressed(ImGuiKey_PageDown)) scroll(0.85f * box.height);
  if (key_pressed(ImGuiKey_PageUp)) scroll(-0.85f * box.height);
}

}  // namespace

float begin_body(const Screen& screen, const Box& box, float height) {
  const float bar = ImGui::GetStyle().ScrollbarSize + screen.ui.layout.size(8);
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild("body", {box.width + bar, box.height});
  if (screen.fresh) ImGui::SetScrollY(0);
  if (height > box.height) scroll_by_keys(screen, box);
  return ImGui::GetCursorScreenPos().y;
}

void end_body(const Screen& screen, const Box& box, float bottom) {
  ImGui::SetCursorScreenPos({box.x, bottom - 1});
  ImGui::Dummy({1, 1});
  const bool goes_on = ImGui::GetScrollMaxY() > ImGui::GetScrollY();
  ImGui::EndChild();
  const float line = screen.ui.layout.size(1);
  if (goes_on) fill({box.x, box.bottom() - line, box.width, line}, screen.ui.look.palette.line);
}

}  // namespace promenade::app
