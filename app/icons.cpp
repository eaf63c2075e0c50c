// The signs on small buttons, drawn by lines: no font that we use has them all.
#include <array>
#include <cmath>
#include <numbers>

#include "app/widgets.h"

namespace promenade::app {
namespace {

struct Pen {
  const Box& box;
  ImU32 colour;
  float thickness;
  ImDrawList* list = ImGui::GetWindowDrawList();

  ImVec2 at(float x, float y) const { return {box.x + x * box.width, box.y + y * box.height}; }
  void line(float x1, float y1, float x2, float y2) const {
    list->AddLine(at(x1, y1), at(x2, y2), colour, thickness);
  }
  void triangle(float x1, float y1, float x2, float y2, float x3, float y3) const {
    list->AddTriangleFilled(at(x1, y1), at(x2, y2), at(x3, y3), colour);
  }
};

// An arrow that turns back over the top; `side` is -1 for undo, 1 for redo.
void draw_turn(const Pen& pen, float side) {
  const auto x = [side](float at) { return 0.5f + side * (at - 0.5f); };
  constexpr int steps = 14;
  for (int k = 0; k <= steps; ++k) {
    const float angle = std::numbers::pi_v<float> * (-0.5f + static_cast<float>(k) / steps * 1.0f);
    const float out = 0.30f;
    pen.list->PathLineTo(pen.at(x(0.42f - out * std::cos(angle)), 0.56f + out * std::sin(angle)));
  }
  pen.list->PathLineTo(pen.at(x(0.55f), 0.86f));
  pen.list->PathStroke(pen.colour, 0, pen.thickness);
  pen.line(x(0.42f), 0.26f, x(0.72f), 0.26f);
  pen.triangle(x(0.70f), 0.04f, x(0.70f), 0.48f, x(0.99f), 0.26f);
}

}  // namespace

void draw_icon(const Box& box, Icon icon, const Rgb& colour, float thickness) {
  const Pen pen{box, packed(colour), thickness};
  switch (icon) {
    case Icon::undo:
      return draw_turn(pen, -1);
    case Icon::redo:
      return draw_turn(pen, 1);
    case Icon::play:
      return pen.triangle(0.2f, 0.08f, 0.2f, 0.92f, 0.9f, 0.5f);
    case Icon::pause:
      fill({box.x + 0.18f * box.width, box.y + 0.1f * box.height, 0.22f * box.width,
            0.8f * box.height},
           colour);
      return fill({box.x + 0.6f * box.width, box.y + 0.1f * box.height, 0.22f * box.width,
                   0.8f * box.height},
                  colour);
    case Icon::plus:
      pen.line(0.5f, 0.1f, 0.5f, 0.9f);
      return pen.line(0.1f, 0.5f, 0.9f, 0.5f);
    case Icon::minus:
      return pen.line(0.1f, 0.5f, 0.9f, 0.5f);
    case Icon::close:
      pen.line(0.18f, 0.18f, 0.82f, 0.82f);
      return pen.line(0.18f, 0.82f, 0.82f, 0.18f);
    case Icon::pen:
      pen.line(0.12f, 0.88f, 0.24f, 0.62f);
      pen.line(0.24f, 0.62f, 0.74f, 0.12f);
      pen.line(0.74f, 0.12f, 0.9f, 0.28f);
      pen.line(0.9f, 0.28f, 0.4f, 0.78f);
      return pen.line(0.4f, 0.78f, 0.12f, 0.88f);
    case Icon::check:
      pen.line(0.2f, 0.52f, 0.42f, 0.74f);
      return pen.line(0.42f, 0.74f, 0.82f, 0.26f);
    case Icon::back:
      pen.line(0.66f, 0.12f, 0.28f, 0.5f);
      return pen.line(0.28f, 0.5f, 0.66f, 0.88f);
  }
}

}  // namespace promenade::app
