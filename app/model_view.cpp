#include "app/model_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/cluster_colours.h"
#include "motion/problem.h"

namespace promenade::app {
namespace {

std::string two_digits(double value) {
  return std::isnan(value) ? "" : fmt::format("{:.2f}", value);
}

}  // namespace

std::vector<std::string> shown_words(const ModelEditor& editor) {
  std::vector<std::string> words = {editor.title()};
  for (const ModelRow& row : editor.rows()) words.push_back(row.name);
  words.insert(words.end(), editor.names().begin(), editor.names().end());
  return words;
}

ModelView::ModelView(ModelEditor& editor, Gui& gui, InputQueue& queue,
                     std::function<void(const study::AdjectiveModel&)> save)
    : editor_(editor), gui_(gui), page_(queue), save_(std::move(save)) {}

void ModelView::frame() {
  page_.frame(gui_, [this](const Ui& ui) { draw(ui); });
}

void ModelView::draw(const Ui& ui) {
  const Palette& palette = ui.look.palette;
  fill(ui.layout.stage(), palette.on_colour);
  fill(ui.layout.panel(), palette.panel);
  draw_head(ui);
  draw_tree(ui);
  Box panel = ui.layout.panel();
  if (editor_.model()) {
    const float high = ui.layout.size(132);
    draw_thresholds(ui, {panel.x, panel.y, panel.width, high});
    panel = {panel.x, panel.y + high, panel.width, panel.height - high};
  }
  draw_table(ui, panel);
  draw_foot(ui);
}

void ModelView::draw_head(const Ui& ui) {
  const Palette& palette = ui.look.palette;
  const Box strip = ui.layout.strip();
  const float inset = ui.layout.size(16);
  const Box line{ui.layout.left + inset, strip.y, strip.width - 2 * inset, strip.height};
  draw_line(ui.look.fonts.title, {line.x, line.y, 0.62f * line.width, line.height}, palette.text,
            editor_.title());
  if (!editor_.simulated()) return;
  const char* words = "Simulated raters: no person has judged";
  const float wide = text_width(ui.look.fonts.bold, words) + 2 * inset;
  const Box flag{line.right() - wide, line.y + ui.layout.size(12), wide, ui.layout.size(32)};
  fill(flag, palette.pilot);
  draw_text(ui.look.fonts.bold, flag, ink_on(palette, palette.pilot), words, Align::centre);
}

void ModelView::draw_thresholds(const Ui& ui, const Box& box) {
  const motion::QuantificationOptions options = editor_.model()->options;
  constexpr double most = 2;
  const float inset = ui.layout.size(16);
  const float step = ui.layout.size(62);
  const auto line = [&](int i) {
    return Box{box.x + inset, box.y + ui.layout.size(6) + static_cast<float>(i) * step,
               box.width - 2 * inset, ui.layout.size(26)};
  };
  const auto row = [&](int i, const char* target, const std::string& label, double value,
                       double standard) {
    draw_text(ui.look.fonts.text, line(i), ui.look.palette.text, label);
    draw_text(ui.look.fonts.bold, line(i), ui.look.palette.text, two_digits(value), Align::right);
    const Box slide{line(i).x, line(i).bottom(), line(i).width, ui.layout.size(28)};
    return slider(ui, "slide", target, slide, std::min(1.0, value / most), standard / most);
  };
  const auto extreme =
      row(0, "mu_star", "Far from neutral somewhere: mu* at least", options.least_extreme, 1);
  const auto deviation =
      row(1, "sigma", "Raters alike: sigma at most", options.most_deviation, 0.85);
  if (!extreme && !deviation) return;
  saved_ = {};
  // To two digits, as is shown.
  const auto rounded = [](double value) { return std::round(100 * most * value) / 100; };
  editor_.set_thresholds(extreme ? rounded(*extreme) : options.least_extreme,
                         deviation ? rounded(*deviation) : options.most_deviation);
}

void ModelView::draw_table(const Ui& ui, const Box& box) {
  const Palette& palette = ui.look.palette;
  const float inset = ui.layout.size(16);
  const float high = ui.layout.size(20);
  const bool pairs = editor_.model() != nullptr;
  const auto cells = [&](float x, float y, float width) {
    const float number = ui.layout.size(52);
    const float name = pairs ? 0.44f * width : 0.62f * width;
    return std::array<Box, 4>{Box{x, y, name, high}, Box{x + name, y, number, high},
                              Box{x + name + number, y, number, high},
                              Box{x + name + (pairs ? 2 * number + inset : inset), y,
                                  width - name - (pairs ? 2 * number + inset : inset), high}};
  };
  const float width = box.width - inset - ImGui::GetStyle().ScrollbarSize;
  const auto head = cells(box.x + inset, box.y + ui.layout.size(4), width);
  draw_text(ui.look.fonts.bold, head[0], palette.text, pairs ? "Pair" : "Feature");
  if (pairs) {
    draw_text(ui.look.fonts.bold, head[1], palette.text, "mu*", Align::right);
    draw_text(ui.look.fonts.bold, head[2], palette.text, "sigma", Align::right);
  }
  draw_text(ui.look.fonts.bold, head[3], palette.text, pairs ? "Fate" : "Slider");
  const float top = head[0].bottom() + ui.layout.size(4);
  ImGui::SetCursorScreenPos({box.x, top});
  ImGui::BeginChild("table", {box.width, box.bottom() - top}, false, ImGuiWindowFlags_NoBackground);
  ImVec2 at = ImGui::GetCursorScreenPos();
  for (const ModelRow& row : editor_.rows()) {
    const auto cell = cells(at.x + inset, at.y, width);
    const Rgb colour = row.cluster < 0 ? palette.quiet : cluster_colour(row.cluster);
    draw_line(ui.look.fonts.text, cell[0], colour, row.name);
    if (pairs) {
      draw_text(ui.look.fonts.text, cell[1], palette.text, two_digits(row.extreme), Align::right);
      draw_text(ui.look.fonts.text, cell[2], palette.text, two_digits(row.deviation), Align::right);
    }
    draw_line(ui.look.fonts.text, cell[3], palette.quiet, row.fate);
    at.y += high;
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::EndChild();
}

void ModelView::draw_foot(const Ui& ui) {
  const Palette& palette = ui.look.palette;
  const Box done = ui.layout.done();
  const Box panel = ui.layout.panel();
  const Box line{panel.x, done.y, done.x - panel.x - ui.layout.size(16), done.height};
  const bool agrees = !editor_.model() || editor_.model()->agreement.agrees();
  std::string words = fmt::format("{} sliders. Drag the dashed line", editor_.names().size());
  if (editor_.model()) words += ", press a name to change it";
  if (editor_.model() && !save_) words += ". To save, start with --out MODEL.toml";
  if (!saved_.words.empty()) words = saved_.words;
  if (!agrees) words = "The ratings do not agree: no sliders";
  const bool alarm = !agrees || saved_.failed;
  draw_paragraphs(ui.look.fonts.text, line.x, line.y + ui.layout.size(4), line.width,
                  alarm ? palette.alarm : palette.text, words);
  if (!save_ || !editor_.model()) return;
  if (button(ui, "save", done, "Save", ButtonKind::filled, agrees && renamed_ < 0)) save();
}

void ModelView::save() {
  saved_ = report_of_saving([this] { save_(*editor_.model()); });
}

}  // namespace promenade::app
