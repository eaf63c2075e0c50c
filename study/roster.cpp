#include "study/roster.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "study/person_code.h"
#include "study/schema.h"
#include "study/sqlite.h"

namespace promenade::study {
namespace {

// How often each station had each cell and each row of the design.
class Stations {
 public:
  Stations(DesignRound round, int stations)
      : round_(round),
        stations_(stations),
        cells_(Eigen::MatrixXi::Zero(stations, round.cells)),
        rows_(Eigen::MatrixXi::Zero(stations, round.rows)) {}

  // The stations of the next turn, one for each of its sequences.
  std::vector<int> turn(int first) {
    int best = rotation_;
    for (int k = 1; k < stations_; ++k) {
      const int rotation = (rotation_ + k) % stations_;
      if (had(first, rotation) < had(first, best)) best = rotation;
    }
    rotation_ = best;
    std::vector<int> dealt;
    for (int i = 0; i < stations_; ++i) {
      const int station = station_of(i, best);
      ++cells_(station, (first + i) % round_.cells);
      ++rows_(station, (first + i) % round_.rows);
      dealt.push_back(station);
    }
    return dealt;
  }

 private:
  int station_of(int place, int rotation) const {
    return (place - rotation + stations_) % stations_;
  }

  // How often they had what they would get.
  int had(int first, int rotation) const {
    int count = 0;
    for (int i = 0; i < stations_; ++i) {
      const int station = station_of(i, rotation);
      count += cells_(station, (first + i) % round_.cells);
      count += rows_(station, (first + i) % round_.rows);
    }
    return count;
  }

  DesignRound round_;
  int stations_, rotation_ = 0;
  Eigen::MatrixXi cells_, rows_;
};

// The n-th code of the study, from 0, unless it is taken already.
std::string new_code(const Study& study, const std::vector<RosterRow>& rows) {
  std::set<std::string> taken;
  for (const RosterRow& row : rows) taken.insert(row.code);
  Rng rng(study.seed, rows.size(), "roster");
  std::string code = draw_person_code(rng);
  while (taken.count(code) > 0) code = draw_person_code(rng);
  return code;
}

std::size_t index_of(const std::string& what, const std::string& typed,
                     const std::vector<RosterRow>& rows) {
  std::vector<std::string> codes;
  for (const RosterRow& row : rows) codes.push_back(row.code);
  const auto found = std::find(codes.begin(), codes.end(), tidy_code(typed));
  if (found != codes.end()) return static_cast<std::size_t>(found - codes.begin());
  const std::string meant = meant_code(typed, codes);
  throw InputError(what, "\"" + typed + "\" is not a code of this roster" +
                             (meant.empty() ? "" : "; did you mean \"" + meant + "\"?"));
}

// One place of the design; its replacements have the same.
int count_places(const std::vector<RosterRow>& rows) {
  return static_cast<int>(std::count_if(rows.begin(), rows.end(),
                                        [](const RosterRow& row) { return row.replaces.empty(); }));
}

}  // namespace

std::string_view to_text(Attendance state) {
  switch (state) {
    case Attendance::booked:
      return "booked";
    case Attendance::done:
      return "done";
    case Attendance::no_show:
      return "no_show";
    case Attendance::replaced:
      return "replaced";
  }
  return "";
}

std::vector<int> deal_stations(DesignRound round, int participants, int stations) {
  Stations dealer(round, stations);
  std::vector<int> dealt;
  while (static_cast<int>(dealt.size()) < participants) {
    const std::vector<int> turn = dealer.turn(static_cast<int>(dealt.size()));
    dealt.insert(dealt.end(), turn.begin(), turn.end());
  }
  dealt.resize(static_cast<std::size_t>(participants));
  return dealt;
}

void extend_roster(const std::string& file, const Study& study, int participants, int stations,
                   std::vector<RosterRow>& rows) {
  const std::vector<int> dealt = deal_stations(round_of(study), participants, stations);
  const int places = count_places(rows);
  if (places > participants) {
    throw InputError(file, fmt::format("has places for {} people already; rows are never taken "
                                       "away",
                                       places));
  }
  for (const RosterRow& row : rows) {
    const auto sequence = static_cast<std::size_t>(row.sequence);
    if (sequence < dealt.size() && row.station == std::to_string(dealt[sequence] + 1)) continue;
    throw InputError(file, fmt::format("was dealt otherwise: {} is at station {} with order {}; "
                                       "name the same number of stations",
                                       row.code, row.station, row.sequence));
  }
  for (int sequence = places; sequence < participants; ++sequence) {
    const int station = dealt[static_cast<std::size_t>(sequence)];
    rows.push_back(
        {new_code(study, rows), std::to_string(station + 1), sequence, Attendance::booked, ""});
  }
}

void mark_no_show(const std::string& file, const std::string& code, std::vector<RosterRow>& rows) {
  RosterRow& row = rows[index_of(file, code, rows)];
  if (row.state != Attendance::booked && row.state != Attendance::no_show) {
    throw InputError(file, fmt::format("{} is {}, not booked", row.code, to_text(row.state)));
  }
  row.state = Attendance::no_show;
}

const RosterRow& replace_person(const std::string& file, const Study& study,
                                const std::string& code, std::vector<RosterRow>& rows) {
  RosterRow& row = rows[index_of(file, code, rows)];
  if (row.state == Attendance::done || row.state == Attendance::replaced) {
    throw InputError(file, fmt::format("{} is {} already; nobody can take this place", row.code,
                                       to_text(row.state)));
  }
  row.state = Attendance::replaced;
  const RosterRow old = row;
  rows.push_back({new_code(study, rows), old.station, old.sequence, Attendance::booked, old.code});
  return rows.back();
}

const RosterRow& find_person(const std::string& what, const std::string& typed,
                             const std::vector<RosterRow>& rows) {
  const RosterRow& row = rows[index_of(what, typed, rows)];
  if (row.state == Attendance::done) {
    throw InputError(what, row.code + " is done already; every person has a code of their own");
  }
  const auto instead = std::find_if(
      rows.begin(), rows.end(), [&](const RosterRow& other) { return other.replaces == row.code; });
  if (row.state == Attendance::replaced) {
    throw InputError(
        what, row.code + " was replaced" + (instead == rows.end() ? "" : " by " + instead->code));
  }
  return row;
}

void refuse_taken_place(const std::string& what, Database& database, const RosterRow& row,
                        bool simulated) {
  check_database(database);
  Statement place(database, "SELECT 1 FROM roster WHERE code = ? AND state = 'done'");
  if (place.bind(1, row.code).step()) {
    throw InputError(what, row.code + " is done already, in " + database.file());
  }
  Statement other(database,
                  "SELECT code FROM session JOIN participant ON participant.uuid = "
                  "session.participant WHERE sequence = ? AND simulated = ? AND pilot = 0 AND "
                  "outcome = 'finished'");
  if (!other.bind(1, row.sequence).bind(2, simulated).step()) return;
  throw InputError(what,
                   fmt::format("order {} of {} was already done by {}, in {}; replace {} in "
                               "the roster or use another database",
                               row.sequence, row.code, other.text(0), database.file(), row.code));
}

int mark_done(Database& database, std::vector<RosterRow>& rows) {
  check_database(database);
  // Its row is written after the session: the program may have died between.
  Statement done(database,
                 "SELECT code FROM roster WHERE state = 'done' UNION SELECT code FROM session "
                 "JOIN participant ON participant.uuid = session.participant WHERE pilot = 0 AND "
                 "outcome = 'finished'");
  int marked = 0;
  while (done.step()) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const RosterRow& one) { return one.code == done.text(0); });
    if (row == rows.end() || row->state == Attendance::done) continue;
    row->state = Attendance::done;
    ++marked;
  }
  return marked;
}

void store_row(Database& database, const RosterRow& row, const std::string& changed_utc) {
  Statement put(database,
                "INSERT INTO roster(code, station, sequence, state, replaces, changed_utc) "
                "VALUES (?,?,?,?,?,?) ON CONFLICT(code) DO UPDATE SET station = "
                "excluded.station, sequence = excluded.sequence, state = excluded.state, "
                "replaces = excluded.replaces, changed_utc = excluded.changed_utc");
  put.bind(1, row.code).bind(2, row.station).bind(3, row.sequence).bind(4, to_text(row.state));
  if (row.replaces.empty()) {
    put.bind_null(5);
  } else {
    put.bind(5, row.replaces);
  }
  put.bind(6, changed_utc).run();
}

}  // namespace promenade::study
