#include "app/parameter_sliders_view.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "app/line_breaks.h"

namespace promenade::app {

using study::InterfacePanel;

namespace {

// Where things are, pixels.
struct Plan {
  Box rows, add, column, toggle;
};

Plan plan_of(const ParameterSliders& sliders, const InterfacePanel& panel) {
  const Box& all = panel.box();
  const float footer = panel.size(40);
  const float above = all.height - footer;
  const float column = panel.size(144);
  const float inset = panel.size(12);
  const bool shown = sliders.weights_visible();
  const float room = all.width - 2 * inset;
  Plan plan;
  plan.rows = {all.x + inset, all.y, shown ? room - column - inset : room, above};
  plan.add = {all.x, all.y + above, panel.size(152), footer};
  plan.column = {all.right() - inset - column, all.y, column, above};
  plan.toggle = {all.right() - panel.size(152), all.y + above, panel.size(152), footer};
  return plan;
}

// A row of 72 pixels: what it is called, the slider, and the words at its ends.
struct RowPlan {
  Box pictogram, title, close, value, slider, low, high;
};

RowPlan row_with_pictogram(const InterfacePanel& panel, const Box& row) {
  const auto size = [&panel](float at_720) { return panel.size(at_720); };
  const float ends = size(64);
  const float line = row.y + size(42);
  RowPlan plan;
  plan.pictogram = {row.x, row.y + size(2), size(40), size(40)};
  plan.title = {row.x + size(44), row.y + size(2), row.width - size(44 + 28), size(40)};
  plan.close = {row.right() - size(28), row.y, size(28), size(24)};
  plan.value = {row.right() - size(72), row.y + size(22), size(72), size(20)};
  plan.slider = {row.x + ends, line, row.width - 2 * ends, size(28)};
  plan.low = {row.x, line, ends - size(4), size(28)};
  plan.high = {row.right() - ends + size(4), line, ends - size(4), size(28)};
  return plan;
}

RowPlan plain_row(const InterfacePanel& panel, const Box& row) {
  const auto size = [&panel](float at_720) { return panel.size(at_720); };
  RowPlan plan;
  plan.title = {row.x, row.y, row.width - size(32), size(24)};
  plan.close = {row.right() - size(28), row.y, size(28), size(24)};
  plan.slider = {row.x, row.y + size(24), row.width, size(28)};
  const float half = 0.5f * row.width;
  plan.low = {row.x, row.y + size(51), half, size(20)};
  plan.high = {row.x + half, row.y + size(51), half, size(20)};
  return plan;
}

// A small triangle: there is more behind this name.
void draw_opens(const InterfacePanel& panel, const ImVec2& at, const Rgb& colour) {
  const float x = at.x + panel.size(8);
  const float half = panel.size(4);
  ImGui::GetWindowDrawList()->AddTriangleFilled({x, at.y - 0.5f * half},
                                                {x + 2 * half, at.y - 0.5f * half},
                                                {x + half, at.y + 0.7f * half}, packed(colour));
}

void draw_title(InterfacePanel& panel, const SliderParameter& parameter, Box box, int lines) {
  if (list_row(panel.ui(), "list", parameter.name, box, "", false)) {
    panel.report({.kind = "list", .target = parameter.name});
  }
  box.width -= panel.size(20);
  const Palette& palette = panel.look().palette;
  draw_opens(panel, draw_parameter_name(panel, parameter, box, lines, palette.text), palette.quiet);
}

void draw_row(const ParameterSliders& sliders, InterfacePanel& panel, const Box& row,
              const ParameterSliders::Slider& slider) {
  const SliderCatalogue& catalogue = sliders.catalogue();
  const auto& parameter = catalogue.parameters[static_cast<std::size_t>(slider.parameter)];
  const bool pictograms = catalogue.pictograms;
  const RowPlan at = pictograms ? row_with_pictogram(panel, row) : plain_row(panel, row);
  const Palette& palette = panel.look().palette;
  ImFont* const font = panel.look().fonts.text;
  Box title = at.title;
  if (!parameter.unit.empty()) title.width = at.value.x - title.x;
  draw_title(panel, parameter, title, pictograms ? 2 : 1);
  panel.press("delete", parameter.name, at.close, Icon::close);
  panel.slide(parameter.name, at.slider, slider.value, sliders.start_of(slider.parameter));
  panel.line(font, at.low, palette.quiet, words_of(panel, parameter.low));
  panel.line(font, at.high, palette.quiet, words_of(panel, parameter.high), Align::right);
  if (!pictograms) return;
  draw_pictogram(at.pictogram, parameter.pictogram, palette);
  if (parameter.unit.empty()) return;
  const ValueText value = value_text(parameter, slider.value);
  panel.line(font, at.value, palette.text, value.view(), Align::right);
}

// A slider that was added comes into sight.
void show_the_last(std::size_t count) {
  int& before = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("count"), 0);
  if (before != 0 && static_cast<int>(count) > before) ImGui::SetScrollY(1e6f);
  before = static_cast<int>(count);
}

void draw_rows(const ParameterSliders& sliders, InterfacePanel& panel, const Box& box) {
  const float height = panel.size(72);
  const float gap = panel.size(8);
  const auto count = static_cast<float>(sliders.sliders().size());
  ImGui::PushID("sliders");
  const float width = panel.begin_scroll(box, gap + height * count);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  float y = origin.y + gap;
  for (const ParameterSliders::Slider& slider : sliders.sliders()) {
    draw_row(sliders, panel, {origin.x, y, width, height}, slider);
    y += height;
  }
  ImGui::SetCursorScreenPos({origin.x, y});
  show_the_last(sliders.sliders().size());
  panel.end_scroll();
  ImGui::PopID();
}

// Two lines where one is too short; returns where the text ends.
ImVec2 draw_lines(ImFont* font, const Box& box, int lines, const Rgb& colour,
                  std::string_view text) {
  const float width = text_width(font, text);
  if (width <= box.width || lines < 2) {
    draw_line(font, box, colour, text);
    return {box.x + std::min(width, box.width), box.middle_y()};
  }
  const auto measure = [font](std::string_view part) { return text_width(font, part); };
  const std::size_t first = first_line(text, box.width, measure);
  const float half = std::round(0.5f * box.height);
  const std::string_view rest = text.substr(first + (text[first] == ' ' ? 1 : 0));
  draw_line(font, {box.x, box.y, box.width, half}, colour, text.substr(0, first));
  draw_line(font, {box.x, box.y + half, box.width, half}, colour, rest);
  return {box.x + std::min(text_width(font, rest), box.width), box.y + 1.5f * half};
}

void draw_add(const ParameterSliders& sliders, InterfacePanel& panel, const Box& box) {
  const Palette& palette = panel.look().palette;
  ImFont* const font = panel.look().fonts.text;
  const float inset = panel.size(12);
  if (sliders.full()) {
    return draw_text(font, {box.x + inset, box.y, box.width, box.height}, palette.quiet,
                     panel.text("sliders.most"));
  }
  if (list_row(panel.ui(), "list", "add", box, "", false)) {
    panel.report({.kind = "list", .target = "add"});
  }
  const float sign = panel.size(16);
  draw_icon({box.x + inset, std::round(box.middle_y() - 0.5f * sign), sign, sign}, Icon::plus,
            palette.quiet, panel.size(2));
  const float from = inset + sign + panel.size(8);
  panel.line(font, {box.x + from, box.y, box.width - from, box.height}, palette.quiet,
             panel.text("sliders.add"));
}

void draw_toggle(const ParameterSliders& sliders, InterfacePanel& panel, const Box& box) {
  const bool shown = sliders.weights_visible();
  panel.press(shown ? "hide" : "show", "weights", box,
              panel.text(shown ? "sliders.hide" : "sliders.show"));
}

int digits_of(const SliderParameter& parameter) {
  if (parameter.unit == "deg") return parameter.highest - parameter.lowest < 10 ? 1 : 0;
  return parameter.unit == "cm" ? 1 : 2;
}

}  // namespace

ValueText value_text(const SliderParameter& parameter, double value) {
  const int digits = digits_of(parameter);
  const double scale = std::pow(10, digits);
  // Without the sign of a zero.
  const double rounded = std::round(in_unit(parameter, value) * scale) / scale + 0.0;
  ValueText text;
  char* const first = text.letters.data();
  char* const last = first + 20;
  char* end = std::to_chars(first, last, rounded, std::chars_format::fixed, digits).ptr;
  const bool degrees = parameter.unit == "deg";
  const std::string_view unit = degrees ? std::string_view("°") : parameter.unit;
  if (!degrees) *end++ = ' ';
  end = std::copy(unit.begin(), unit.end(), end);
  text.size = static_cast<std::size_t>(end - first);
  return text;
}

std::string_view words_of(const InterfacePanel& panel, const Words& words) {
  const std::string* text = panel.content().texts.find(words.key);
  return text != nullptr ? *text : words.fallback;
}

ImVec2 draw_parameter_name(InterfacePanel& panel, const SliderParameter& parameter, const Box& box,
                           int lines, const Rgb& colour) {
  ImFont* const font = panel.look().fonts.text;
  const std::string_view title = words_of(panel, parameter.title);
  if (!title.empty()) return draw_lines(font, box, lines, colour, title);
  // A pair: "slow – fast".
  constexpr std::string_view between = " – ";
  const float dash = text_width(font, between);
  const std::string_view words[] = {words_of(panel, parameter.low),
                                    words_of(panel, parameter.high)};
  const float most = 0.5f * (box.width - dash);
  const float low = text_width(font, words[0]);
  const float high = text_width(font, words[1]);
  const bool fits = low + dash + high <= box.width;
  Box at = box;
  at.width = fits ? low + 1 : most;
  draw_line(font, at, colour, words[0]);
  at.x += fits ? low : most;
  draw_text(font, at, colour, between);
  at.x += dash;
  at.width = fits ? high + 1 : most;
  draw_line(font, at, colour, words[1]);
  return {at.right(), box.middle_y()};
}

void draw_sliders(const study::InterfaceState& state, InterfacePanel& panel) {
  const auto& sliders = static_cast<const ParameterSliders&>(state);
  if (sliders.list() != ParameterSliders::List::closed) return draw_parameter_list(sliders, panel);
  const Plan plan = plan_of(sliders, panel);
  draw_rows(sliders, panel, plan.rows);
  if (sliders.sliders().empty()) {
    draw_lines(panel.look().fonts.text,
               {plan.rows.x, plan.rows.y + panel.size(16), plan.rows.width, panel.size(44)}, 2,
               panel.look().palette.quiet, panel.text("sliders.none"));
  }
  draw_add(sliders, panel, plan.add);
  if (sliders.weights_visible()) draw_weights_column(sliders, panel, plan.column);
  if (sliders.catalogue().column != WeightsColumn::hidden) draw_toggle(sliders, panel, plan.toggle);
}

}  // namespace promenade::app
