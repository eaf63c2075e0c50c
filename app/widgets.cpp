#include "app/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/line_breaks.h"
#include "study/utf8.h"

namespace promenade::app {
namespace {

ImVec2 low(const Box& box) { return {box.x, box.y}; }
ImVec2 high(const Box& box) { return {box.right(), box.bottom()}; }

struct Touch {
  bool pressed, clicked, hovered, held, focused;
};

void draw_ring(const Ui& ui, const Box& box) {
  const float out = ui.layout.size(2);
  ImGui::GetForegroundDrawList()->AddRect({box.x - out, box.y - out},
                                          {box.right() + out, box.bottom() + out},
                                          packed(ui.look.palette.text), 0, 0, ui.layout.size(2));
}

// In sight, if it is in a list that scrolls.
void scroll_to(const Box& box) {
  if (ImGui::GetScrollMaxY() <= 0) return;
  ImGui::SetScrollFromPosY(box.middle_y() - ImGui::GetWindowPos().y, 0.5f);
}

// Enters the widget into the map and draws the ring; is the keyboard on it?
bool enter(const Ui& ui, std::string_view kind, std::string_view target, Widget& widget,
           const Box& box) {
  widget.box = box;
  widget.view = visible_box();
  ui.widgets.add(kind, target, widget);
  if (!ui.focus.on(kind, target)) return false;
  if (ui.focus.arrived() && !widget.visible()) scroll_to(box);
  if (ui.focus.ring() && widget.visible()) draw_ring(ui, box);
  return true;
}

// The invisible part of every widget: where it can be touched.
Touch touch(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
            Widget widget = {}) {
  if (ui.inert) return {};
  const bool focused = enter(ui, kind, target, widget, box);
  ImGui::PushID(kind.data(), kind.data() + kind.size());
  ImGui::PushID(target.data(), target.data() + target.size());
  ImGui::SetCursorScreenPos(low(box));
  const bool clicked = ImGui::InvisibleButton("", {box.width, box.height});
  ImGui::PopID();
  ImGui::PopID();
  const bool pressed = ImGui::IsItemActivated();
  if (pressed) ui.focus.take(kind, target);
  const bool key = focused && !ImGui::GetIO().WantTextInput &&
                   (key_pressed(ImGuiKey_Enter, false) || key_pressed(ImGuiKey_Space, false));
  return {pressed || key, clicked || key, ImGui::IsItemHovered(), ImGui::IsItemActive(), focused};
}

float line_height(ImFont* font) { return std::round(font->FontSize * 1.08f); }

}  // namespace

bool place(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
           bool stop) {
  if (ui.inert) return false;
  Widget widget;
  widget.stop = stop;
  return enter(ui, kind, target, widget, box);
}

bool pressed_area(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                  bool stop) {
  Widget widget;
  widget.stop = stop;
  return touch(ui, kind, target, box, widget).pressed;
}

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

bool answer_button(const Ui& ui, std::string_view target, const Box& box, std::string_view label,
                   bool chosen, bool stop, const Rgb* ground) {
  const Palette& palette = ui.look.palette;
  Widget widget;
  widget.on = chosen;
  widget.stop = stop;
  const Touch now = touch(ui, "press", target, box, widget);
  const float dim = now.held ? 0.86f : now.hovered ? 0.93f : 1;
  const Rgb& colour = ground != nullptr ? *ground : palette.created;
  fill(box, dim * (chosen ? colour : palette.on_colour));
  if (!chosen) frame(box, palette.line, ui.layout.size(1));
  draw_text(chosen ? ui.look.fonts.bold : ui.look.fonts.text, box,
            chosen ? palette.on_colour : palette.text, label, Align::centre);
  return now.clicked;
}

bool answer_area(const Ui& ui, std::string_view target, const Box& box, bool chosen) {
  Widget widget;
  widget.on = chosen;
  return touch(ui, "press", target, box, widget).clicked;
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

bool tile(const Ui& ui, std::string_view kind, std::string_view target, const Box& box) {
  const Touch now = touch(ui, kind, target, box);
  const Palette& palette = ui.look.palette;
  const float thickness = ui.layout.size(now.hovered ? 2 : 1);
  frame(box, now.hovered ? palette.created : palette.line, thickness);
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
  draw_line(marked ? ui.look.fonts.bold : ui.look.fonts.text,
            {box.x + inset, box.y, box.width - 2 * inset, box.height},
            marked ? palette.on_colour : palette.text, label);
  return now.pressed;
}

namespace {

// Where the arrow keys take a slider.
std::optional<double> slid_by_key(double value) {
  const double step = ImGui::GetIO().KeyShift ? 0.1 : 0.01;
  const auto steps = [&](double by) { return std::clamp(value + by, 0.0, 1.0); };
  if (key_pressed(ImGuiKey_LeftArrow)) return steps(-step);
  if (key_pressed(ImGuiKey_RightArrow)) return steps(step);
  if (key_pressed(ImGuiKey_Home)) return 0;
  if (key_pressed(ImGuiKey_End)) return 1;
  return std::nullopt;
}

// Where the mouse or the keys take it. A press beside the knob brings it there; one
// within `radius` of it takes it as it is.
std::optional<double> dragged(const Touch& now, const Widget& widget, float radius, double value) {
  float& grip = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("grip"));
  const float span = widget.at_one - widget.at_zero;
  const float mouse = ImGui::GetIO().MousePos.x;
  if (now.pressed) grip = std::abs(mouse - widget.knob) <= radius ? widget.knob - mouse : 0;
  if (now.held && ImGui::IsMouseDown(0)) {
    const double wanted =
        std::clamp(static_cast<double>((mouse + grip - widget.at_zero) / span), 0.0, 1.0);
    const float at = widget.at_zero + span * static_cast<float>(wanted);
    const bool same_pixel = std::abs(at - widget.knob) < 0.25f;
    return same_pixel ? std::nullopt : std::optional(wanted);
  }
  const std::optional<double> moved = now.focused ? slid_by_key(value) : std::nullopt;
  return moved == value ? std::nullopt : moved;
}

}  // namespace

std::optional<double> drag_bar(const Ui& ui, std::string_view kind, std::string_view target,
                               const Box& box, double value) {
  Widget widget;
  widget.slides = true;
  widget.at_zero = box.x;
  widget.at_one = box.right();
  widget.knob = box.x + box.width * static_cast<float>(value);
  return dragged(touch(ui, kind, target, box, widget), widget, 0, value);
}

std::optional<double> slider(const Ui& ui, std::string_view kind, std::string_view target,
                             const Box& box, double value, double start) {
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
  const Touch now = touch(ui, kind, target, box, widget);

  const std::optional<double> moved = dragged(now, widget, radius, value);
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

bool icon_button(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                 Icon icon, bool enabled, bool stop) {
  const Palette& palette = ui.look.palette;
  Widget widget;
  widget.stop = stop;
  const Touch now = touch(ui, kind, target, box, widget);
  if (now.hovered && enabled) fill(box, palette.hover);
  const float inset = std::round(0.5f * (std::min(box.width, box.height) - ui.layout.size(18)));
  const Box sign{box.middle_x() - ui.layout.size(9), box.y + inset, ui.layout.size(18),
                 ui.layout.size(18)};
  draw_icon(sign, icon, enabled ? palette.text : palette.line, ui.layout.size(2));
  return now.clicked && enabled;
}

namespace {

struct Writing {
  int most;
  bool goes_on;  // what is there stays: writing begins behind it
};

// Dear ImGui asks after each edit, else once a frame.
int mind_text(ImGuiInputTextCallbackData* data) {
  const auto& writing = *static_cast<const Writing*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) {
    const std::string_view text(data->Buf, static_cast<std::size_t>(data->BufTextLen));
    const auto end = static_cast<int>(study::first_characters(text, writing.most).size());
    if (end < data->BufTextLen) data->DeleteChars(end, data->BufTextLen - end);
  } else if (writing.goes_on) {
    data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
  }
  return 0;
}

// The field itself, the kind and target of which are on the stack of names. Was Enter pressed?
bool input_text(const Ui& ui, bool focused, std::array<char, 256>& buffer,
                const FieldOptions& options) {
  bool& active = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("active"));
  Writing writing{options.most, focused && ui.focus.goes_on() && !active};
  if (focused && ui.focus.arrived()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint("", options.hint, buffer.data(), buffer.size(),
                                                ImGuiInputTextFlags_EnterReturnsTrue |
                                                    ImGuiInputTextFlags_CallbackEdit |
                                                    ImGuiInputTextFlags_CallbackAlways,
                                                mind_text, &writing);
  active = ImGui::IsItemActive();
  return entered;
}

}  // namespace

bool text_field(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                std::string& text, const FieldOptions& options) {
  const float pad = std::round(0.5f * (box.height - ImGui::GetFontSize()));
  fill(box, ui.look.palette.on_colour);
  frame(box, ui.look.palette.line, ui.layout.size(1));
  if (ui.inert) {
    draw_text(ui.look.fonts.text, {box.x + ui.layout.size(12), box.y, box.width, box.height},
              ui.look.palette.quiet, options.hint);
    return false;
  }
  Widget widget;
  const bool focused = enter(ui, kind, target, widget, box);
  std::array<char, 256> buffer{};
  const std::size_t length = std::min(text.size(), buffer.size() - 1);
  std::copy_n(text.begin(), length, buffer.begin());
  ImGui::PushID(kind.data(), kind.data() + kind.size());
  ImGui::PushID(target.data(), target.data() + target.size());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ui.layout.size(12), pad});
  ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
  ImGui::SetCursorScreenPos(low(box));
  ImGui::SetNextItemWidth(box.width);
  const bool entered = input_text(ui, focused, buffer, options);
  if (ImGui::IsItemActivated() && !focused) ui.focus.take(kind, target);
  const bool edited = text != buffer.data();
  if (edited) text = buffer.data();
  if (options.entered != nullptr) *options.entered = entered;
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::PopID();
  ImGui::PopID();
  return edited;
}

PlaneTouch plane(const Ui& ui, std::string_view kind, std::string_view target, const Box& box,
                 const Eigen::Vector2f& zero, const Eigen::Vector2f& unit) {
  Widget widget;
  widget.plane = true;
  widget.zero_x = zero.x();
  widget.zero_y = zero.y();
  widget.unit_x = unit.x();
  widget.unit_y = unit.y();
  const Touch now = touch(ui, kind, target, box, widget);
  const ImGuiIO& io = ImGui::GetIO();
  PlaneTouch result;
  result.hovered = now.hovered;
  result.pressed = now.pressed && ImGui::IsMouseDown(0);
  result.held = now.held && ImGui::IsMouseDown(0);
  result.moved = {io.MouseDelta.x, io.MouseDelta.y};
  result.pan = now.hovered && (ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2));
  result.wheel = now.hovered ? io.MouseWheel : 0;
  result.focused = now.focused;
  return result;
}

}  // namespace promenade::app
