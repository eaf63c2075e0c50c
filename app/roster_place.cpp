#include "app/roster_place.h"

#include <algorithm>
#include <filesystem>

#include "app/print.h"
#include "motion/files.h"
#include "study/identity.h"
#include "study/migrate.h"
#include "study/person_code.h"
#include "study/sqlite.h"

namespace promenade::app {
namespace {

using study::Attendance;
using study::RosterRow;

std::vector<RosterRow> rows_of(const RosterCheck& check) {
  return study::read_roster(check.roster, read_file(check.roster));
}

const RosterRow* row_of(const std::string& typed, const std::vector<RosterRow>& rows) {
  const std::string code = study::tidy_code(typed);
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const RosterRow& one) { return one.code == code; });
  return row == rows.end() ? nullptr : &*row;
}

RosterRow place_in(const std::vector<RosterRow>& rows, const RosterCheck& check,
                   const std::string& what) {
  RosterRow row = study::find_person(what, check.participant, rows);
  std::error_code ignored;
  if (std::filesystem::exists(check.database, ignored)) {
    study::Database database = study::open_log(check.database);
    study::refuse_taken_place(what, database, row, check.simulated);
  }
  if (row.station != check.station) {
    print_problems({{what, 0, 0,
                     "the roster expects " + row.code + " at station \"" + row.station +
                         "\", this is \"" + check.station + "\"",
                     Severity::warning}});
  }
  return row;
}

}  // namespace

RosterRow roster_place(const RosterCheck& check) {
  return place_in(rows_of(check), check, "--participant " + check.participant);
}

RosterAnswer ask_roster(const RosterCheck& check) {
  const std::vector<RosterRow> rows = rows_of(check);
  if (row_of(check.participant, rows) == nullptr) return {RosterAnswer::Kind::unknown};
  try {
    return {RosterAnswer::Kind::welcome, place_in(rows, check, "the code on the welcome page")};
  } catch (const InputError& error) {
    print_problems(error.problems());
    return {RosterAnswer::Kind::taken};
  }
}

RosterRow next_place(RosterCheck check) {
  const std::vector<RosterRow> rows = rows_of(check);
  for (const RosterRow& row : rows) {
    if (row.state != Attendance::booked || row.station != check.station) continue;
    check.participant = row.code;
    try {
      return place_in(rows, check, row.code);
    } catch (const InputError&) {
      continue;  // somebody has taken it
    }
  }
  throw InputError(check.roster, "expects nobody any more at station \"" + check.station + "\"");
}

void store_place(const RosterCheck& check, study::Outcome outcome) {
  const std::vector<RosterRow> rows = rows_of(check);
  const RosterRow* place = row_of(check.participant, rows);
  if (place == nullptr) return;
  RosterRow row = *place;
  row.state = outcome == study::Outcome::finished ? Attendance::done : Attendance::booked;
  study::Database file(check.database, study::Database::Mode::read_write);
  study::store_row(file, row, study::utc_now());
}

}  // namespace promenade::app
