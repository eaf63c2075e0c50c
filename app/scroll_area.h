// A part of the window that the wheel scrolls; the Tab key brings what it comes to into sight.
#pragma once

#include <imgui.h>

#include "app/box.h"

namespace promenade::app {

// `high`: how much there is to see, pixels; `draw` gets the box of it all, whose upper edge is
// above the area's once it was scrolled.
template <typename Draw>
void scrolled(const char* name, const Box& box, float high, const Draw& draw) {
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild(name, {box.width, box.height}, false, ImGuiWindowFlags_NoBackground);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float bar = high > box.height ? ImGui::GetStyle().ScrollbarSize : 0;
  draw(Box{at.x, at.y, box.width - bar, high});
  ImGui::SetCursorScreenPos({at.x, at.y + high});
  ImGui::EndChild();
}

}  // namespace promenade::app
