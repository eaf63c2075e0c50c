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
  const float inset = panel.size(8);
  const float column = sliders.weights_visible() ? panel.size(142) : 0;
  const float below = panel.size(160);
  Plan plan;
  plan.rows = {all.x + inset, all.y, all.width - column - 2 * inset, above};
  plan.add = {all.x, all.y + above, below, footer};
  plan.column = {all.right() - column, all.y, column, above};
  plan.toggle = {all.right() - below, all.y + above, below, footer};
  return plan;
}

// A row of 72 pixels: its name, the slider, and under it the words at its ends.
struct RowPlan {
  Box title, pictogram, slider, close, ends;
};

RowPlan plan_of_row(const InterfacePanel& panel, const Box& row, bool pictogram) {
  const auto size = [&panel](float at_720) { return panel.size(at_720); };
  const float from = row.x + (pictogram ? size(48) : 0);
  const float width = row.right() - size(32) - from;
  RowPlan plan;
  plan.title = {row.x, row.y, row.width, size(22)};
  plan.pictogram = {row.x, row.y + size(22), size(40), size(40)};
  plan.slider = {from, row.y + size(20), width, size(28)};
  plan.close = {row.right() - size(28), row.y + size(20), size(28), size(28)};
  plan.ends = {from, row.y + size(47), width, size(18)};
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

void draw_title(InterfacePanel& panel, const SliderParameter& parameter, const Box& box) {
  if (list_row(panel.ui(), "list", parameter.name, box, "", false)) {
    panel.report({.kind = "list", .target = parameter.name});
  }
  const Palette& palette = panel.look().palette;
  const float end = draw_parameter_name(panel, parameter, box, palette.text);
  if (end + panel.size(18) <= box.right()) {
    draw_opens(panel, {end, box.middle_y()}, palette.quiet);
  }
}

void draw_ends(InterfacePanel& panel, const SliderParameter& parameter, const Box& box,
               double value) {
  const Palette& palette = panel.look().palette;
  ImFont* const font = panel.look().fonts.text;
  const bool measured = !parameter.unit.empty();
  const float room = std::floor((measured ? 0.33f : 0.5f) * box.width);
  const Box low{box.x, box.y, room, box.height};
  const Box high{box.right() - room, box.y, room, box.height};
  panel.line(font, low, palette.quiet, words_of(panel, parameter.low));
  panel.line(font, high, palette.quiet, words_of(panel, parameter.high), Align::right);
  if (!measured) return;
  panel.line(font, box, palette.text, value_text(parameter, value).view(), Align::centre);
}

void draw_row(const ParameterSliders& sliders, InterfacePanel& panel, const Box& row,
              const ParameterSliders::Slider& slider) {
  const SliderCatalogue& catalogue = sliders.catalogue();
  const auto& parameter = catalogue.parameters[static_cast<std::size_t>(slider.parameter)];
  const RowPlan at = plan_of_row(panel, row, catalogue.pictograms);
  draw_title(panel, parameter, at.title);
  panel.slide(parameter.name, at.slider, slider.value, sliders.start_of(slider.parameter));
  panel.press("delete", parameter.name, at.close, Icon::close);
  draw_ends(panel, parameter, at.ends, slider.value);
  if (catalogue.pictograms) {
    draw_pictogram(at.pictogram, parameter.pictogram, panel.look().palette);
  }
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

// What the panel shows without any slider.
void draw_none(InterfacePanel& panel, const Box& box) {
  const std::string_view text = panel.text("sliders.none");
  ImFont* const font = panel.look().fonts.text;
  const auto measure = [font](std::string_view part) { return text_width(font, part); };
  const float height = panel.size(22);
  Box line{box.x + panel.size(8), box.y + panel.size(8), box.width - panel.size(8), height};
  for (std::size_t at = 0; at < text.size(); line.y += height) {
    const std::size_t end = at + first_line(text.substr(at), line.width, measure);
    panel.line(font, line, panel.look().palette.quiet, text.substr(at, end - at));
    const bool broken = end < text.size() && (text[end] == ' ' || text[end] == '\n');
    at = broken ? end + 1 : end;
  }
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
  const Captions& captions = panel.content().captions;
  const auto own = words.own.find(captions.language);
  if (own != words.own.end()) return own->second;
  const std::string* text = captions.texts.find(words.key);
  return text != nullptr ? *text : words.fallback;
}

float draw_parameter_name(InterfacePanel& panel, const SliderParameter& parameter, const Box& box,
                          const Rgb& colour) {
  ImFont* const font = panel.look().fonts.text;
  const std::string_view title = words_of(panel, parameter.title);
  if (!title.empty()) {
    draw_line(font, box, colour, title);
    return box.x + std::min(text_width(font, title), box.width);
  }
  // A pair: "slow – fast".
  constexpr std::string_view between = " – ";
  const std::string_view low = words_of(panel, parameter.low);
  const std::string_view high = words_of(panel, parameter.high);
  const float dash = text_width(font, between);
  const float half = 0.5f * (box.width - dash);
  const float widths[] = {text_width(font, low) + 1, text_width(font, high) + 1};
  const bool fits = widths[0] + dash + widths[1] <= box.width;
  Box at{box.x, box.y, fits ? widths[0] : half, box.height};
  draw_line(font, at, colour, low);
  at.x = at.right();
  draw_text(font, at, colour, between);
  at.x += dash;
  at.width = fits ? widths[1] : half;
  draw_line(font, at, colour, high);
  return at.right();
}

void draw_sliders(const study::InterfaceState& state, InterfacePanel& panel) {
  const auto& sliders = static_cast<const ParameterSliders&>(state);
  if (sliders.list() != ParameterSliders::List::closed) return draw_parameter_list(sliders, panel);
  const Plan plan = plan_of(sliders, panel);
  draw_rows(sliders, panel, plan.rows);
  if (sliders.sliders().empty()) draw_none(panel, plan.rows);
  draw_add(sliders, panel, plan.add);
  if (sliders.weights_visible()) draw_weights_column(sliders, panel, plan.column);
  if (sliders.catalogue().column != WeightsColumn::hidden) draw_toggle(sliders, panel, plan.toggle);
}

}  // namespace promenade::app
