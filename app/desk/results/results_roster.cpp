#include "app/desk/results/results_roster.h"

#include <algorithm>
#include <filesystem>

#include "app/desk/table.h"
#include "motion/files.h"

namespace promenade::app {
namespace {

constexpr TableColumn columns[] = {
    {"results.code", 0.02f, 0.3f}, {"results.station", 0.3f, 0.45f}, {"results.order", 0.45f, 0.6f},
    {"results.state", 0.6f, 0.8f}, {"results.replaces", 0.8f, 1},
};

}  // namespace

void ResultsRoster::read() {
  rows_.clear();
  trouble_.clear();
  try {
    if (study::is_there(place_.roster())) {
      rows_ = study::read_roster(place_.roster(), read_file(place_.roster()));
    }
  } catch (const std::exception& error) {
    trouble_ = error.what();
  }
  shown_ = {trouble_};
  for (const study::RosterRow& row : rows_) shown_.push_back(row.station);
  const auto bundle = study_.bundle();
  const int planned = bundle ? bundle->study.participants : 0;
  if (rows_.empty() && planned > 0) people_.value = std::min(planned, 1000);
  if (rows_.empty()) return;
  people_.value =
      static_cast<int>(std::count_if(rows_.begin(), rows_.end(), [](const study::RosterRow& row) {
        return row.replaces.empty();
      }));
}

const study::RosterRow* ResultsRoster::chosen() const {
  for (const study::RosterRow& row : rows_) {
    if (row.code == chosen_) return &row;
  }
  return nullptr;
}

void ResultsRoster::draw_list(const Ui& ui, const study::Texts& words, const Box& box) {
  const Palette& palette = ui.look.palette;
  if (rows_.empty()) {
    Column column(ui, inside(ui, box, 32));
    column.skip(80);
    column.words(ui.look.fonts.reading, trouble_.empty() ? palette.quiet : palette.alarm,
                 trouble_.empty() ? words("results.no_roster") : trouble_);
    return;
  }
  draw_table(ui, words, "roster", box, columns, ui.layout.size(36), rows_.size(),
             [&](std::size_t i, const Box& row) { draw_row(ui, words, rows_[i], row); });
}

void ResultsRoster::draw_row(const Ui& ui, const study::Texts& words, const study::RosterRow& one,
                             const Box& box) {
  const Palette& palette = ui.look.palette;
  fill(box, one.code == chosen_ ? palette.known : palette.panel);
  if (tile(ui, "booked", one.code, box)) chosen_ = one.code;
  const auto cell = [&](std::size_t column, const Rgb& colour, std::string_view text) {
    draw_line(ui.look.fonts.text, cell_of(box, columns[column]), colour, text);
  };
  cell(0, palette.text, one.code);
  cell(1, palette.text, one.station);
  cell(2, palette.text, std::to_string(one.sequence + 1));
  cell(3, palette.text, words("results.attendance." + std::string(study::to_text(one.state))));
  cell(4, palette.quiet, one.replaces);
}

void ResultsRoster::command(const study::Texts& words, const std::vector<std::string>& options) {
  std::vector<std::string> command{"roster", place_.file(), "--out", place_.roster()};
  command.insert(command.end(), options.begin(), options.end());
  services_.jobs.start(words("results.roster"), command, [this](const Job&) { read(); });
}

void ResultsRoster::draw_chosen(const Ui& ui, const study::Texts& words, Column& column,
                                std::int64_t now_us) {
  const bool idle = !services_.jobs.busy();
  if (const study::RosterRow* const row = chosen()) {
    const std::string code = row->code;
    const bool over =
        row->state == study::Attendance::done || row->state == study::Attendance::replaced;
    draw_line(ui.look.fonts.title, column.take(36), ui.look.palette.text, code);
    const Box line = column.take(40, 20);
    if (button(ui, "no_show", part_of_row(ui, line, 0, 2), words("results.no_show"),
               ButtonKind::outlined, idle && row->state == study::Attendance::booked)) {
      return command(words, {"--no-show", code});
    }
    if (button(ui, "replace", part_of_row(ui, line, 1, 2), words("results.replace"),
               ButtonKind::outlined, idle && !over)) {
      return command(words, {"--replace", code});
    }
  }
  column.words(ui.look.fonts.text, ui.look.palette.quiet, words("results.roster_says"), 12);
  const float wide = ui.layout.size(170);
  const auto number = [&](const char* key, const char* target, NumberDraft& value, int most) {
    const Box line = column.take(40);
    draw_text(ui.look.fonts.text, line, ui.look.palette.text, words(key));
    number_box(ui, target, {line.right() - wide, line.y, wide, line.height}, value, 1, most,
               now_us);
  };
  number("results.people", "roster.people", people_, 1000);
  number("results.stations", "roster.stations", stations_, 100);
  if (button(ui, "deal", column.take(44), words("results.deal"), ButtonKind::outlined, idle)) {
    return command(words, {"--participants", std::to_string(people_.value), "--stations",
                           std::to_string(stations_.value)});
  }
  if (button(ui, "mark_done", column.take(44), words("results.mark_done"), ButtonKind::outlined,
             idle && !rows_.empty() && study::is_there(place_.sessions()))) {
    command(words, {"--done-in", place_.sessions()});
  }
}

}  // namespace promenade::app
