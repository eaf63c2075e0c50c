#include "app/widgets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/line_breaks.h"

namespace promenade::app {
namespace {

ImVec2 low(const Box& box) { return {box.x, box.y}; }
ImVec2 high(const Box& box) { return {box.right(), box.bottom()}; }

struct Touch {
  bool pressed, clicked, hovered, held;
};

// The invisible part of every widget: where it can be touched.
Touch touch(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
            Widget widget = {}) {
  widget.box = box;
  widget.view = visible_box();
  ui.widgets.add(kind, target, widget);
  ImGui::PushID(kind.data(), kind.data() + kind.size());
  ImGui::PushID(target.data(), target.data() + target.size());
  ImGui::SetCursorScreenPos(low(box));
  const bool clicked = ImGui::InvisibleButton("", {box.width, box.height});
  ImGui::PopID();
  ImGui::PopID();
  return {ImGui::IsItemActivated(), clicked, ImGui::IsItemHovered(), ImGui::IsItemActive()};
}

float line_height(ImFont* font) { return std::round(font->FontSize * 1.08f); }

}  // namespace

Box visible_box() {
  const ImVec2 from = ImGui::GetWindowDrawList()->GetClipRectMin();
  const ImVec2 to = ImGui::GetWindowDrawList()->GetClipRectMax();
  return {from.x, from.y, to.x - from.x, to.y - from.y};
}

float text_width(ImFont* font, std::string_view text) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

void draw_text(ImFont* font, const Box& box, const Rgb& colour, std::string_view text,
               Align align) {
  const float room = box.width - (align == Align::left ? 0 : text_width(font, text));
  const float share = align == Align::left ? 0 : align == Align::centre ? 0.5f : 1;
  const ImVec2 at(std::round(box.x + share * room),
                  std::round(box.middle_y() - 0.5f * font->FontSize));
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, at, packed(colour), text.data(),
                                      text.data() + text.size());
}

float draw_paragraphs(ImFont* font, float x, float y, float width, const Rgb& colour,
                      std::string_view text) {
  const float step = line_height(font);
  const auto lines =
      break_lines(text, width, [font](std::string_view part) { return text_width(font, part); });
  float at = y;
  for (const std::string_view line : lines) {
    if (!line.empty()) draw_text(font, {x, at, width, step}, colour, line);
    at += line.empty() ? std::round(0.5f * step) : step;
  }
  return at - y;
}

float paragraphs_height(ImFont* font, float width, std::string_view text) {
  const float step = line_height(font);
  float height = 0;
  for (const std::string_view line :
       break_lines(text, width, [font](std::string_view part) { return text_width(font, part); })) {
    height += line.empty() ? std::round(0.5f * step) : step;
  }
  return height;
}

void fill(const Box& box, const Rgb& colour) {
  ImGui::GetWindowDrawList()->AddRectFilled(low(box), high(box), packed(colour));
}

void frame(const Box& box, const Rgb& colour, float thickness) {
  fill({box.x, box.y, box.width, thickness}, colour);
  fill({box.x, box.bottom() - thickness, box.width, thickness}, colour);
  fill({box.x, box.y, thickness, box.height}, colour);
  fill({box.right() - thickness, box.y, thickness, box.height}, colour);
}

bool button(const Ui& ui, std::string_view target, const Box& box, std::string_view label,
            ButtonKind kind, bool enabled) {
  const Palette& palette = ui.look.palette;
  const Touch now = touch(ui, "press", target, box);
  const bool filled = kind == ButtonKind::filled;
  const float dim = !enabled ? 0.45f : now.held ? 0.86f : now.hovered ? 0.93f : 1;
  const auto toned = [&](const Rgb& colour) -> Rgb {
    return enabled ? Rgb(dim * colour) : Rgb(dim * colour + (1 - dim) * palette.background);
  };
  if (filled) fill(box, toned(palette.created));
  if (kind == ButtonKind::outlined || (kind == ButtonKind::quiet && now.hovered && enabled)) {
    fill(box, toned(kind == ButtonKind::outlined ? palette.on_colour : palette.hover));
  }
  if (kind == ButtonKind::outlined) frame(box, palette.line, ui.layout.size(1));
  const Rgb ink = filled ? palette.on_colour : enabled ? palette.text : palette.quiet;
  draw_text(filled ? ui.look.fonts.bold : ui.look.fonts.text, box, ink, label, Align::centre);
  return now.clicked && enabled;
}

bool small_button(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                  std::string_view label) {
  const Palette& palette = ui.look.palette;
  const Touch now = touch(ui, kind, target, box);
  if (now.hovered) fill(box, palette.hover);
  draw_text(ui.look.fonts.text, box, now.hovered ? palette.text : palette.quiet, label,
            Align::centre);
  return now.clicked;
}

bool list_row(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
              std::string_view label, bool marked) {
  const Palette& palette = ui.look.palette;
  const Touch now = touch(ui, kind, target, box);
  if (marked) {
    fill(box, palette.created);
  } else if (now.hovered) {
    fill(box, palette.hover);
  }
  const float inset = ui.layout.size(16);
  draw_text(marked ? ui.look.fonts.bold : ui.look.fonts.text,
            {box.x + inset, box.y, box.width - inset, box.height},
            marked ? palette.on_colour : palette.text, label);
  return now.pressed;
}

std::optional<double> slider(const Ui& ui, std::string_view target, const Box& box, double value,
                             double start) {
  const Palette& palette = ui.look.palette;
  const float radius = ui.layout.size(14);
  const float from = box.x + radius;
  const float span = box.width - 2 * radius;
  const auto place = [&](double at) { return from + span * static_cast<float>(at); };
  Widget widget;
  widget.slides = true;
  widget.knob = place(value);
  widget.at_zero = from;
  widget.at_one = from + span;
  const Touch now = touch(ui, "slide", target, box, widget);

  // A press beside the knob brings it there; one on it takes it as it is.
  float& grip = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("grip"));
  const float mouse = ImGui::GetIO().MousePos.x;
  if (now.pressed) grip = std::abs(mouse - widget.knob) <= radius ? widget.knob - mouse : 0;
  std::optional<double> moved;
  if (now.held) {
    const double wanted = std::clamp(static_cast<double>((mouse + grip - from) / span), 0.0, 1.0);
    const bool same_pixel = std::abs(place(wanted) - widget.knob) < 0.25f;
    if (!same_pixel) moved = wanted;
  }
  const float y = std::round(box.middle_y());
  const float half = std::max(1.0f, ui.layout.size(2));
  const float knob = place(moved.value_or(value));
  const float tick = std::round(place(start));
  fill({tick - half / 2, y - radius, half, 2 * radius}, palette.line);
  fill({from, y - half, span, 2 * half}, palette.track);
  fill({from, y - half, knob - from, 2 * half}, palette.created);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float size = now.held || now.hovered ? radius : radius - ui.layout.size(1);
  list->AddCircleFilled({knob, y}, size, packed(palette.created), 32);
  list->AddCircleFilled({knob, y}, size - ui.layout.size(4), packed(palette.on_colour), 32);
  return moved;
}

}  // namespace promenade::app
