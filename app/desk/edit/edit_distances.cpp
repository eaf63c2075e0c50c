#include "app/desk/edit/edit_distances.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scroll_area.h"

namespace promenade::app {
namespace {

constexpr float name_share = 0.36f;
constexpr float row_height = 30;

}  // namespace

void EditDistances::follow(const std::shared_ptr<const study::StudyBundle>& bundle) {
  if (bundle == nullptr || bundle == bundle_) return;
  const bool same = bundle_ != nullptr && bundle_->sha256 == bundle->sha256;
  bundle_ = bundle;
  if (same) return;
  table_ = {};
  count_ = 0;
  progress_ = std::make_shared<Progress>();
  work_.start([bundle, progress = progress_](const std::stop_token& ended) {
    Table table;
    try {
      table.reports = report_targets(*bundle, [&](const auto& done, std::size_t count) {
        const std::lock_guard lock(progress->mutex);
        progress->reports = done;
        progress->count = count;
        return !ended.stop_requested();
      });
      table.warnings = warnings_of(bundle->file, table.reports);
    } catch (const std::exception& error) {  // the window lives on, and says so
      table.warnings.push_back({bundle->file, 0, 0, error.what(), Severity::error});
    }
    return table;
  });
}

void EditDistances::advance() {
  if (auto found = work_.news()) {
    table_.warnings = std::move(found->warnings);
    return show(std::move(found->reports));
  }
  if (!working()) return;
  const std::lock_guard lock(progress_->mutex);
  count_ = progress_->count;
  if (progress_->reports.size() == table_.reports.size()) return;
  table_.warnings.clear();
  show(progress_->reports);
}

void EditDistances::show(std::vector<TargetReport> reports) {
  table_.reports = std::move(reports);
  columns_.clear();
  for (const TargetReport& report : table_.reports) {
    for (const InterfaceReach& one : report.reaches) {
      const bool known =
          std::find(columns_.begin(), columns_.end(), one.interface) != columns_.end();
      if (!known) columns_.push_back(one.interface);
    }
  }
}

void EditDistances::draw(const FormPass& pass, const Box& box) {
  const Ui& ui = pass.ui;
  const Palette& palette = ui.look.palette;
  ImFont* const font = ui.look.fonts.text;
  float y = box.y + ui.layout.size(4);
  y += draw_paragraphs(font, box.x, y, box.width, palette.quiet, pass.words("edit.distances_help"));
  y += ui.layout.size(8);
  if (working()) {
    const std::string text = pass.words.with(
        "edit.distances_work",
        {{"done", std::to_string(table_.reports.size())}, {"count", std::to_string(count_)}});
    draw_text(ui.look.fonts.bold, {box.x, y, box.width, ui.layout.size(28)}, palette.text, text);
    y += ui.layout.size(32);
  } else if (table_.reports.empty()) {
    draw_text(font, {box.x, y, box.width, ui.layout.size(28)}, palette.quiet,
              pass.words("edit.no_targets"));
    return;
  }
  const float bar = ImGui::GetStyle().ScrollbarSize;
  const float width = box.width - bar;
  float high = static_cast<float>(table_.reports.size() + 1) * ui.layout.size(row_height);
  for (const Problem& one : table_.warnings) {
    high += paragraphs_height(font, width, one.message) + ui.layout.size(8);
  }
  scrolled("distances", {box.x, y, box.width, box.bottom() - y}, high, [&](const Box& inner) {
    float at = draw_rows(pass, {inner.x, inner.y, width, inner.height}) + ui.layout.size(8);
    for (const Problem& one : table_.warnings) {
      at += draw_paragraphs(font, inner.x, at, width, palette.steps.front(), one.message);
      at += ui.layout.size(8);
    }
  });
}

Box EditDistances::cell(const Box& row, std::size_t column) const {
  const auto count = static_cast<float>(columns_.size() + 1);
  const float wide = (1 - name_share) * row.width / count;
  return {row.x + name_share * row.width + static_cast<float>(column) * wide, row.y, wide,
          row.height};
}

float EditDistances::draw_rows(const FormPass& pass, const Box& box) const {
  const Ui& ui = pass.ui;
  Box row{box.x, box.y, box.width, ui.layout.size(row_height)};
  if (table_.reports.empty()) return row.y;
  const auto head = [&](std::size_t column, const std::string& text) {
    const Box one = cell(row, column);
    draw_line(ui.look.fonts.bold,
              {one.x + ui.layout.size(6), one.y, one.width - ui.layout.size(12), one.height},
              ui.look.palette.text, text, Align::right);
  };
  draw_line(ui.look.fonts.bold, {row.x, row.y, name_share * row.width, row.height},
            ui.look.palette.text, pass.words("edit.target_column"));
  head(0, pass.words("edit.start_column"));
  for (std::size_t i = 0; i < columns_.size(); ++i) head(i + 1, columns_[i]);
  row.y += row.height;
  for (const TargetReport& report : table_.reports) {
    draw_row(pass, report, row);
    row.y += row.height;
  }
  return row.y;
}

// Amber: out of reach, or met by chance.
void EditDistances::draw_row(const FormPass& pass, const TargetReport& report,
                             const Box& row) const {
  const Ui& ui = pass.ui;
  const Palette& palette = ui.look.palette;
  fill({row.x, row.y, row.width, ui.layout.size(1)}, palette.line);
  std::string name = report.task + ": " + report.target;
  if (report.practice) name += " (" + pass.words("edit.practice_mark") + ")";
  if (report.sequence) name += fmt::format(" {}", *report.sequence + 1);
  draw_line(ui.look.fonts.text,
            {row.x, row.y, name_share * row.width - ui.layout.size(8), row.height}, palette.text,
            name);
  const auto number = [&](std::size_t column, double metres, bool amber) {
    const Box one = cell(row, column);
    const float in = ui.layout.size(4);
    if (amber)
      fill({one.x + in, one.y + in, one.width - in, one.height - 2 * in},
           0.3f * palette.pilot + 0.7f * palette.on_colour);
    draw_text(ui.look.fonts.text, {one.x, one.y, one.width - ui.layout.size(6), one.height},
              palette.text, fmt::format("{:.3f}", metres), Align::right);
  };
  if (!report.reaches.empty()) number(0, report.reaches.front().reach.start, false);
  for (std::size_t i = 0; i < report.reaches.size(); ++i) {
    const InterfaceReach& one = report.reaches[i];
    const auto column = std::find(columns_.begin(), columns_.end(), one.interface);
    number(static_cast<std::size_t>(column - columns_.begin()) + 1, one.reach.best,
           is_out_of_reach(report, i) || is_favoured(report, i));
  }
}

}  // namespace promenade::app
