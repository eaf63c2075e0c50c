// The roster as a table.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "motion/did_you_mean.h"
#include "study/csv.h"
#include "study/person_code.h"
#include "study/roster.h"

namespace promenade::study {
namespace {

enum Column { code, station, sequence, state, replaces, column_count };
constexpr std::array<const char*, column_count> names = {"code", "station", "sequence", "state",
                                                         "replaces"};
constexpr std::array<Attendance, 4> states = {Attendance::booked, Attendance::done,
                                              Attendance::no_show, Attendance::replaced};
constexpr int largest_sequence = 1'000'000;

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  std::vector<RosterRow> read(std::string_view text) {
    const std::vector<CsvRow> rows = parse_csv(text);
    if (rows.empty()) throw InputError(file_, "is empty; `promenade roster` makes a roster");
    find_columns(rows[0]);
    refuse();
    std::vector<RosterRow> roster;
    for (std::size_t i = 1; i < rows.size(); ++i) roster.push_back(row_of(rows[i]));
    refuse();
    for (std::size_t i = 1; i < rows.size(); ++i) check_replaced(rows[i]);
    refuse();
    return roster;
  }

 private:
  void report(Place place, const std::string& message) {
    problems_.push_back({file_, place.line, place.column, message, Severity::error});
  }
  void refuse() const {
    if (!problems_.empty()) throw InputError(problems_);
  }

  void find_columns(const CsvRow& header) {
    for (std::size_t c = 0; c < column_count; ++c) {
      const auto found = std::find(header.cells.begin(), header.cells.end(), names[c]);
      column_[c] = static_cast<std::size_t>(found - header.cells.begin());
      if (found != header.cells.end()) continue;
      const std::string meant = closest_name(names[c], header.cells);
      report(header.place(0), fmt::format("there is no column \"{}\"{}", names[c],
                                          meant.empty() ? "" : "; is it \"" + meant + "\"?"));
    }
  }

  // Empty where the row is too short: spreadsheets leave out empty cells at the end.
  std::string cell(const CsvRow& row, Column column) const {
    const std::size_t at = column_[column];
    return at < row.cells.size() ? row.cells[at] : "";
  }

  RosterRow row_of(const CsvRow& row) {
    RosterRow made{cell(row, code), cell(row, station), 0, Attendance::booked, cell(row, replaces)};
    if (!is_person_code(made.code)) {
      report(row.place(column_[code]),
             fmt::format("\"{}\" is not a code: its check fails", made.code));
    } else if (!codes_.insert(made.code).second) {
      report(row.place(column_[code]),
             fmt::format("the code \"{}\" stands there twice", made.code));
    }
    if (made.station.empty()) report(row.place(column_[station]), "the station is empty");
    made.sequence = sequence_in(row);
    made.state = state_in(row);
    return made;
  }

  int sequence_in(const CsvRow& row) {
    const auto number = parse_number(cell(row, sequence));
    const bool whole = number && *number == static_cast<int>(std::clamp(*number, 0.0, 1e6));
    if (whole && *number < largest_sequence) return static_cast<int>(*number);
    report(row.place(column_[sequence]),
           fmt::format("the sequence \"{}\" is not a whole number from 0", cell(row, sequence)));
    return 0;
  }

  Attendance state_in(const CsvRow& row) {
    std::vector<std::string> words;
    for (const Attendance one : states) {
      if (cell(row, state) == to_text(one)) return one;
      words.emplace_back(to_text(one));
    }
    report(row.place(column_[state]),
           fmt::format("the state \"{}\" must be one of {}{}", cell(row, state), quoted_list(words),
                       did_you_mean(cell(row, state), words)));
    return Attendance::booked;
  }

  void check_replaced(const CsvRow& row) {
    const std::string old = cell(row, replaces);
    if (old.empty() || codes_.count(old) > 0) return;
    report(row.place(column_[replaces]),
           fmt::format("there is no code \"{}\" that could be replaced", old));
  }

  const std::string& file_;
  std::array<std::size_t, column_count> column_{};
  std::set<std::string> codes_;
  std::vector<Problem> problems_;
};

}  // namespace

std::vector<RosterRow> read_roster(const std::string& file, std::string_view text) {
  return Reader(file).read(text);
}

std::string roster_csv(const std::vector<RosterRow>& rows) {
  std::string text = "code,station,sequence,state,replaces\n";
  for (const RosterRow& row : rows) {
    text += fmt::format("{},{},{},{},{}\n", row.code, csv_cell(row.station), row.sequence,
                        to_text(row.state), row.replaces);
  }
  return text;
}

}  // namespace promenade::study
