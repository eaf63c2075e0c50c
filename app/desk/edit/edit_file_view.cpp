#include "app/desk/edit/edit_file_view.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/line_breaks.h"
#include "app/scroll_area.h"

namespace promenade::app {
namespace {

constexpr float row_height = 22;
constexpr float number_width = 44;
constexpr float continued = 20;  // a line that goes on is set in

float step_of(const Ui& ui) { return ui.layout.size(row_height); }

// The worst that is said about a line; null: nothing is.
const PlacedProblem* worst_at(const std::vector<PlacedProblem>& problems, int line) {
  const PlacedProblem* worst = nullptr;
  for (const PlacedProblem& one : problems) {
    if (one.line != line) continue;
    if (worst == nullptr || one.problem.severity == Severity::error) worst = &one;
  }
  return worst;
}

Rgb mark_of(const Palette& palette, Severity severity) {
  return severity == Severity::error ? palette.alarm : palette.pilot;
}

// A quarter of the colour on the ground.
Rgb pale(const Palette& palette, const Rgb& colour) {
  return 0.14f * colour + 0.86f * palette.on_colour;
}

// Behind the value of an entry everything is a remark.
std::size_t remark_of(const study::TomlStatement& statement, std::size_t begin, std::size_t end) {
  if (statement.kind == study::TomlStatement::Kind::remark) return begin;
  if (statement.kind != study::TomlStatement::Kind::entry) return end;
  return std::clamp(statement.entry.value.end, begin, end);
}

}  // namespace

void EditFileView::add_line(const Ui& ui, const std::string& text, std::size_t begin,
                            std::size_t end, const study::TomlStatement* statement, float width) {
  ImFont* const font = ui.look.fonts.text;
  const std::string_view line = std::string_view(text).substr(begin, end - begin);
  const auto measure = [font](std::string_view part) { return text_width(font, part); };
  Row row;
  row.line = ++lines_;
  row.header = statement != nullptr && statement->is_header();
  row.remark = statement != nullptr ? remark_of(*statement, begin, end) : end;
  for (const std::string_view part : break_lines(line, width, measure)) {
    row.begin = begin + static_cast<std::size_t>(part.data() - line.data());
    row.end = row.begin + part.size();
    rows_.push_back(row);
    row.goes_on = true;
  }
  if (!row.goes_on) rows_.push_back({begin, begin, row.line});
}

void EditFileView::lay_out(const Ui& ui, const study::StudyDraft& draft, float width) {
  if (version_ == draft.version() && width_ == width) return;
  version_ = draft.version();
  width_ = width;
  rows_.clear();
  lines_ = 0;
  const std::string& text = draft.text();
  const study::TomlSpans& spans = draft.spans();
  std::size_t at = 0, statement = 0;
  while (at < text.size()) {
    std::size_t end = std::min(text.find('\n', at), text.size());
    const std::size_t next = std::min(end + 1, text.size());
    if (end > at && text[end - 1] == '\r') --end;
    while (statement < spans.size() && spans[statement].end <= at) ++statement;
    add_line(ui, text, at, end, statement < spans.size() ? &spans[statement] : nullptr, width);
    at = next;
  }
}

void EditFileView::find_focus(const study::StudyDraft& draft, const study::TomlPath& focused) {
  first_ = last_ = 0;
  study::TomlPath path = focused;
  std::optional<study::Span> span = study::span_of(draft.spans(), path);
  // A key that is not there yet would stand in its table.
  while (!span && path.size() > 1) {
    path.pop_back();
    span = study::span_of(draft.spans(), path);
  }
  moved_ = moved_ || focused != focused_;
  focused_ = focused;
  if (focused.empty() || !span) return;
  first_ = study::line_at(draft.text(), span->begin);
  if (moved_) chosen_ = first_;
  last_ = path == focused ? study::line_at(draft.text(), std::max(span->end, span->begin + 1) - 1)
                          : first_;
}

void EditFileView::bring_into_sight(const Ui& ui, float view_height) {
  const int line = wanted_ > 0 ? wanted_ : moved_ ? first_ : 0;
  moved_ = false;
  wanted_ = 0;
  if (line == 0) return;
  const auto row =
      std::find_if(rows_.begin(), rows_.end(), [line](const Row& one) { return one.line == line; });
  const float y = static_cast<float>(row - rows_.begin()) * step_of(ui);
  const float top = ImGui::GetScrollY();
  const float edge = 2 * step_of(ui);
  if (y > top + edge && y < top + view_height - 2 * edge) return;
  ImGui::SetScrollY(std::max(0.0f, y - 0.3f * view_height));
}

void EditFileView::draw_row(const Ui& ui, const std::string& text, const Row& row,
                            const Box& box) const {
  const Palette& palette = ui.look.palette;
  ImFont* const font = row.header ? ui.look.fonts.bold : ui.look.fonts.text;
  const float numbers = ui.layout.size(number_width);
  if (!row.goes_on) {
    draw_text(ui.look.fonts.text, {box.x, box.y, numbers - ui.layout.size(10), box.height},
              palette.quiet, std::to_string(row.line), Align::right);
  }
  const std::size_t middle = std::clamp(row.remark, row.begin, row.end);
  const std::string_view words = std::string_view(text).substr(row.begin, middle - row.begin);
  const std::string_view remark = std::string_view(text).substr(middle, row.end - middle);
  const float in = row.goes_on ? numbers + ui.layout.size(continued) : numbers;
  Box place{box.x + in, box.y, box.width - in, box.height};
  draw_text(font, place, palette.text, words);
  place.x += text_width(font, words);
  draw_text(ui.look.fonts.text, place, palette.quiet, remark);
}

void EditFileView::choose_by_key(const Ui& ui, float view_height) {
  if (!ui.focus.on("press", "file")) return;
  const int page = std::max(1, static_cast<int>(0.8f * view_height / step_of(ui)));
  int by = 0;
  if (key_pressed(ImGuiKey_DownArrow)) by = 1;
  if (key_pressed(ImGuiKey_UpArrow)) by = -1;
  if (key_pressed(ImGuiKey_PageDown)) by = page;
  if (key_pressed(ImGuiKey_PageUp)) by = -page;
  if (by != 0) show(std::clamp(chosen_ + by, 1, std::max(1, lines_)));
}

std::optional<int> EditFileView::draw(const Ui& ui, const Box& box, const study::StudyDraft& draft,
                                      const std::vector<PlacedProblem>& problems,
                                      const study::TomlPath& focused) {
  const Palette& palette = ui.look.palette;
  fill(box, palette.on_colour);
  const float bar = ImGui::GetStyle().ScrollbarSize;
  lay_out(ui, draft, box.width - bar - ui.layout.size(number_width + continued + 4));
  find_focus(draft, focused);
  std::optional<int> pressed;
  const float step = step_of(ui);
  scrolled("file", box, static_cast<float>(rows_.size()) * step, [&](const Box& inner) {
    choose_by_key(ui, box.height);
    bring_into_sight(ui, box.height);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Row& row = rows_[i];
      const Box line{inner.x, inner.y + static_cast<float>(i) * step, inner.width, step};
      if (line.bottom() < box.y || line.y > box.bottom()) continue;
      const PlacedProblem* worst = worst_at(problems, row.line);
      if (row.line >= first_ && row.line <= last_) fill(line, palette.known);
      if (worst != nullptr) {
        const Rgb mark = mark_of(palette, worst->problem.severity);
        fill(line, pale(palette, mark));
        fill({line.x, line.y, ui.layout.size(6), line.height}, mark);
      }
      draw_row(ui, draft.text(), row, line);
      if (row.line == chosen_ && !row.goes_on) {
        fill({line.x + ui.layout.size(number_width - 6), line.y, ui.layout.size(2), line.height},
             palette.created);
      }
    }
    const Box all{inner.x, inner.y, inner.width, std::max(inner.height, 1.0f)};
    if (pressed_area(ui, "press", "file", all) && ImGui::IsMouseDown(0)) {
      const float at = (ImGui::GetIO().MousePos.y - inner.y) / step;
      const auto row = std::min(static_cast<std::size_t>(std::max(at, 0.0f)), rows_.size() - 1);
      if (!rows_.empty()) pressed = chosen_ = rows_[row].line;
    }
  });
  return pressed;
}

namespace {

std::string place_of(const study::Texts& words, const PlacedProblem& one) {
  if (one.line > 0) return words.with("edit.line", {{"line", std::to_string(one.line)}});
  return one.problem.file;
}

}  // namespace

std::optional<std::size_t> draw_problem_list(const Ui& ui, const study::Texts& words,
                                             const Box& box,
                                             const std::vector<PlacedProblem>& problems,
                                             bool working) {
  const Palette& palette = ui.look.palette;
  ImFont* const font = ui.look.fonts.text;
  const float edge = ui.layout.size(10);
  const float head = ui.layout.size(26);
  const std::string title =
      working ? words("edit.checking")
      : problems.empty()
          ? words("edit.no_problems")
          : words.with("edit.problems", {{"count", std::to_string(problems.size())}});
  draw_text(ui.look.fonts.bold, {box.x, box.y, box.width, head},
            working || problems.empty() ? palette.quiet : palette.text, title);
  const Box view{box.x, box.y + head, box.width, box.height - head};
  const float bar = ImGui::GetStyle().ScrollbarSize;
  const float width = view.width - bar - 3 * edge;
  std::vector<std::string> texts;
  float high = 0;
  for (const PlacedProblem& one : problems) {
    texts.push_back(place_of(words, one) + ": " + one.problem.message);
    high += paragraphs_height(font, width, texts.back()) + edge;
  }
  std::optional<std::size_t> pressed;
  scrolled("problems", view, high, [&](const Box& inner) {
    float y = inner.y;
    for (std::size_t i = 0; i < problems.size(); ++i) {
      const float room = paragraphs_height(font, width, texts[i]) + edge;
      const Box row{inner.x, y, view.width - bar, room};
      if (small_button(ui, "press", fmt::format("problem/{}", i), row, "")) pressed = i;
      fill({row.x, row.y + 0.5f * edge, ui.layout.size(6), row.height - edge},
           mark_of(palette, problems[i].problem.severity));
      draw_paragraphs(font, row.x + 2 * edge, row.y + 0.5f * edge, width, palette.text, texts[i]);
      y += room;
    }
  });
  return pressed;
}

}  // namespace promenade::app
