// A part of the window that the wheel scrolls; the Tab key brings what it comes to into sight.
#pragma once

#include <imgui.h>

#include "app/box.h"

namespace promenade::app {

// How wide what it shows is: beside the bar, when one is needed.
inline float scrolled_width(const Box& box, float high) {
  return box.width - (high > box.height ? ImGui::GetStyle().ScrollbarSize : 0);
}

// `high`: how much there is to see, pixels; `draw` gets the box of it all, whose upper edge is
// above the area's once it was scrolled.
template <typename Draw>
void scrolled(const char* name, const Box& box, float high, const Draw& draw) {
  ImGui::SetCursorScreenPos({box.x, box.y});
  ImGui::BeginChild(name, {box.width, box.height}, false, ImGuiWindowFlags_NoBackground);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw(Box{at.x, at.y, scrolled_width(box, high), high});
  ImGui::SetCursorScreenPos({at.x, at.y + high});
  ImGui::EndChild();
}

}  // namespace promenade::app
