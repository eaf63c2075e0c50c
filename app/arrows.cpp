#include "app/arrows.h"

#include <algorithm>

namespace promenade::app {

void draw_arrow(const Box& box, Arrow arrow, const Rgb& colour, float thickness) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const ImU32 ink = packed(colour);
  const auto at = [&](float x, float y) {
    return ImVec2(box.x + x * box.width, box.y + y * box.height);
  };
  const float tip = arrow == Arrow::up ? 0.12f : 0.88f;
  const float wing = arrow == Arrow::up ? 0.44f : 0.56f;
  switch (arrow) {
    case Arrow::up:
    case Arrow::down:
      list->AddLine(at(0.5f, 0.12f), at(0.5f, 0.88f), ink, thickness);
      list->AddLine(at(0.2f, wing), at(0.5f, tip), ink, thickness);
      return list->AddLine(at(0.5f, tip), at(0.8f, wing), ink, thickness);
    case Arrow::folded:
      return list->AddTriangleFilled(at(0.3f, 0.15f), at(0.3f, 0.85f), at(0.78f, 0.5f), ink);
    case Arrow::unfolded:
      return list->AddTriangleFilled(at(0.15f, 0.3f), at(0.85f, 0.3f), at(0.5f, 0.78f), ink);
  }
}

bool arrow_button(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                  Arrow arrow, bool enabled) {
  const bool pressed = small_button(ui, kind, target, box, "");
  const float side = ui.layout.size(16);
  draw_arrow({box.middle_x() - 0.5f * side, box.middle_y() - 0.5f * side, side, side}, arrow,
             enabled ? ui.look.palette.text : ui.look.palette.line, ui.layout.size(2));
  return pressed && enabled;
}

}  // namespace promenade::app
