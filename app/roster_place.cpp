#include "app/roster_place.h"

#include <filesystem>

#include "app/print.h"
#include "motion/files.h"
#include "study/identity.h"
#include "study/sqlite.h"

namespace promenade::app {

using study::Attendance;
using study::RosterRow;

study::RosterRow roster_place(const RosterCheck& check) {
  const std::string what = "--participant " + check.participant;
  if (check.participant.empty()) {
    throw InputError("--roster " + check.roster, "needs --participant CODE, one of its codes");
  }
  const auto rows = study::read_roster(check.roster, read_file(check.roster));
  RosterRow row = study::find_person(what, check.participant, rows);
  std::error_code ignored;
  if (std::filesystem::exists(check.database, ignored)) {
    study::Database database(check.database, study::Database::Mode::read_only);
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

void store_place(const std::string& database, RosterRow row, study::Outcome outcome) {
  row.state = outcome == study::Outcome::finished ? Attendance::done : Attendance::booked;
  study::Database file(database, study::Database::Mode::read_write);
  study::store_row(file, row, study::utc_now());
}

}  // namespace promenade::app
