#include "app/desk/results/results_roster.h"

#include <algorithm>
#include <filesystem>

#include "app/scroll_area.h"
#include "motion/files.h"

namespace promenade::app {

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
  const float head = ui.layout.size(32);
  const float row = ui.layout.size(36);
  const auto cell = [&](const Box& line, float from, float to, const Rgb& colour,
                        std::string_view text) {
    draw_line(ui.look.fonts.text,
              {line.x + from * line.width, line.y, (to - from) * line.width, line.height}, colour,
              text);
  };
  const Box titles{box.x, box.y, box.width, head};
  cell(titles, 0.02f, 0.3f, palette.quiet, words("results.code"));
  cell(titles, 0.3f, 0.45f, palette.quiet, words("results.station"));
  cell(titles, 0.45f, 0.6f, palette.quiet, words("results.order"));
  cell(titles, 0.6f, 0.8f, palette.quiet, words("results.state"));
  cell(titles, 0.8f, 1, palette.quiet, words("results.replaces"));
  const Box room{box.x, box.y + head, box.width, box.height - head};
  scrolled("roster", room, row * static_cast<float>(rows_.size()), [&](const Box& all) {
    Box line{all.x, all.y, all.width, row - ui.layout.size(2)};
    for (const study::RosterRow& one : rows_) {
      fill(line, one.code == chosen_ ? palette.known : palette.panel);
      if (tile(ui, "booked", one.code, line)) chosen_ = one.code;
      cell(line, 0.02f, 0.3f, palette.text, one.code);
      cell(line, 0.3f, 0.45f, palette.text, one.station);
      cell(line, 0.45f, 0.6f, palette.text, std::to_string(one.sequence + 1));
      cell(line, 0.6f, 0.8f, palette.text,
           words("results.attendance." + std::string(study::to_text(one.state))));
      cell(line, 0.8f, 1, palette.quiet, one.replaces);
      line.y += row;
    }
  });
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
