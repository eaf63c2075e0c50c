#include "study/session_list.h"

#include "study/sqlite.h"

namespace promenade::study {

std::vector<ListedSession> list_sessions(Database& database) {
  Statement row(database,
                "SELECT session.uuid, code, station, started_utc, outcome, pilot, simulated, "
                "(SELECT count(*) FROM trial WHERE trial.session = session.uuid AND NOT practice "
                "AND NOT superseded AND outcome IN ('success', 'timeout', 'done')) "
                "FROM session JOIN participant ON participant.uuid = session.participant "
                "ORDER BY started_utc, session.rowid");
  std::vector<ListedSession> sessions;
  while (row.step()) {
    ListedSession one;
    one.uuid = row.text(0);
    one.participant = row.text(1);
    one.station = row.text(2);
    one.started_utc = row.text(3);
    one.outcome = row.text(4);
    one.pilot = row.integer(5) != 0;
    one.simulated = row.integer(6) != 0;
    one.trials = static_cast<int>(row.integer(7));
    sessions.push_back(std::move(one));
  }
  return sessions;
}

}  // namespace promenade::study
