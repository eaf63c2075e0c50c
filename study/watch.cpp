#include "study/watch.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>

#include "study/migrate.h"
#include "study/schema.h"
#include "study/session_length.h"
#include "study/sqlite.h"
#include "study/stored_study.h"
#include "study/versions.h"
#include "study/watched_log.h"

namespace promenade::study {
namespace {

constexpr int timed_people = 3;
constexpr int longest_wait_ms = 200;
constexpr int listed_h = 12;  // since the end of a session

// The header of a session as it stands now; the rest of what is known of it stays.
void take_header(const Statement& row, FollowedSession& session) {
  WatchedSession& told = session.told;
  told.uuid = row.text(0);
  session.study_uuid = row.text(1);
  told.participant = row.text(2);
  told.station = row.text(3);
  told.language = row.text(4);
  told.started_utc = row.text(5);
  told.ended_utc = row.text(6);
  told.outcome = row.text(7);
  told.simulated = row.integer(8) != 0;
  told.pilot = row.integer(9) != 0;
  session.sequence = static_cast<int>(row.integer(10));
  session.process = row.integer(11);
  session.process_start = row.text(12);
  session.alive_us = std::max(session.alive_us, row.integer(13));
}

// Those who run keep their places; what waits or is over goes from the latest to the first.
bool comes_before(const WatchedSession& a, const WatchedSession& b) {
  const auto group = [](const WatchedSession& one) {
    switch (one.state) {
      case WatchedState::running:
      case WatchedState::paused:
        return 0;
      case WatchedState::left:
      case WatchedState::interrupted:
        return 1;
      case WatchedState::ended:
        return 2;
    }
    return 2;
  };
  if (group(a) != group(b)) return group(a) < group(b);
  if (group(a) == 0) return a.started_utc < b.started_utc;
  return group(a) == 1 ? a.started_utc > b.started_utc : a.ended_utc > b.ended_utc;
}

std::string message_of(const InputError& error) {
  const std::vector<Problem>& problems = error.problems();
  return problems.empty() ? "cannot be read" : problems.front().message;
}

// Made a moment ago, by a process that has yet to fill it.
bool is_being_made(const std::string& file) {
  try {
    Database database(file, Database::Mode::read_only);
    return is_blank(database);
  } catch (const OutsideError&) {
    return false;
  }
}

}  // namespace

std::optional<double> WatchedTrial::left_s() const {
  if (!limit_s) return std::nullopt;
  return std::max(0.0, *limit_s - seconds);
}

std::string_view to_text(WatchedState state) {
  switch (state) {
    case WatchedState::running:
      return "running";
    case WatchedState::paused:
      return "paused";
    case WatchedState::left:
      return "left";
    case WatchedState::interrupted:
      return "interrupted";
    case WatchedState::ended:
      return "ended";
  }
  return "";
}

Watch::Watch(std::string file, const InterfaceRegistry& registry)
    : file_(std::move(file)), registry_(registry) {}
Watch::~Watch() = default;

void Watch::forget() {
  known_.clear();
  listed_.clear();
  newest_.clear();
  studies_.clear();
  now_ = {};
}

const Watched& Watch::look(const std::string& now_utc) {
  now_.problem.clear();
  now_.is_input_error = now_.waits = now_.is_locked = false;
  try {
    refresh(now_utc);
  } catch (const InputError& error) {
    stamp_ = {};
    const bool waits = is_being_made(file_);
    now_.problem = file_ + (waits ? " is being made" : " " + message_of(error));
    now_.is_input_error = !waits;
    now_.waits = waits;
  } catch (const DatabaseError& error) {
    stamp_ = {};
    now_.problem = error.what();
    now_.is_locked = error.code() == SQLITE_BUSY || error.code() == SQLITE_LOCKED;
  } catch (const std::exception& error) {
    stamp_ = {};  // as it was, and once more next time
    now_.problem = error.what();
  }
  tell(now_utc);
  return now_;
}

// A file whose journal is gone is read without locks (study/sqlite.cpp); should a writer have
// come meanwhile, what was read is of no use.
void Watch::refresh(const std::string& now_utc) {
  constexpr int tries = 5;
  for (int i = 0; i < tries; ++i) {
    const DatabaseStamp before = database_stamp(file_);
    if (before.file.file != stamp_.file.file && stamp_.file.file != 0) forget();
    if (before.file.file == 0) {
      forget();
      stamp_ = {};
      now_.waits = true;
      now_.problem = file_ + " is not there yet: it is made when the first session begins";
      return;
    }
    if (before == stamp_ && calm_) return;
    // Within one tick of the disk's clock a second change looks like none.
    calm_ = before == stamp_;
    read(now_utc);
    stamp_ = before;
    if (before.journal.file != 0 || database_stamp(file_) == before) return;
    forget();
    stamp_ = {};
  }
}

void Watch::read(const std::string& now_utc) {
  Database database = open_log(file_, longest_wait_ms);
  read_study(database);
  database.exec("BEGIN");  // what is read from here on belongs together
  read_sessions(database, now_utc);
  database.exec("COMMIT");
  // Heavy the first time, and so not in there.
  for (const std::string& uuid : listed_) plan(database, *known_.at(uuid));
}

void Watch::read_study(Database& database) {
  const std::vector<StudyVersion> versions = study_versions(database);
  if (versions.empty() || versions.back().uuid == newest_) return;
  newest_ = versions.back().uuid;
  now_.study = versions.back().name;
  now_.version = versions.back().version;
  const StudyBundle* bundle = study_of(database, newest_);
  now_.planned = bundle != nullptr ? bundle->study.participants : 0;
}

const StudyBundle* Watch::study_of(Database& database, const std::string& uuid) {
  const auto known = studies_.find(uuid);
  if (known != studies_.end()) return known->second.get();
  std::unique_ptr<StudyBundle>& bundle = studies_[uuid];
  try {
    bundle = std::make_unique<StudyBundle>(read_stored_study(database, uuid, registry_));
  } catch (const InputError&) {
    // Of another version of the program: who is where is known all the same.
  }
  return bundle.get();
}

void Watch::read_sessions(Database& database, const std::string& now_utc) {
  Statement counts(database,
                   "SELECT count(*) FILTER (WHERE NOT simulated AND NOT pilot), "
                   "count(*) FILTER (WHERE pilot AND NOT simulated), "
                   "count(*) FILTER (WHERE simulated) FROM session WHERE outcome = 'finished'");
  counts.step();
  now_.finished = static_cast<int>(counts.integer(0));
  now_.finished_pilot = static_cast<int>(counts.integer(1));
  now_.finished_simulated = static_cast<int>(counts.integer(2));
  Statement row(database,
                "SELECT session.uuid, study, code, station, language, started_utc, "
                "coalesce(ended_utc, ''), outcome, simulated, pilot, sequence, "
                "coalesce(process, 0), coalesce(process_start, ''), coalesce(alive_us, 0) "
                "FROM session JOIN participant ON participant.uuid = session.participant "
                "WHERE outcome = 'running' OR process IS NOT NULL OR "
                "ended_utc >= strftime('%Y-%m-%dT%H:%M:%SZ', ?, ?) "
                "ORDER BY started_utc, session.rowid");
  row.bind(1, now_utc).bind(2, fmt::format("-{} hours", listed_h));
  listed_.clear();
  while (row.step()) {
    std::unique_ptr<FollowedSession>& session = known_[row.text(0)];
    listed_.push_back(row.text(0));
    if (!session) session = std::make_unique<FollowedSession>();
    if (session->settled) continue;
    take_header(row, *session);
    follow(database, *session);
  }
}

void Watch::plan(Database& database, FollowedSession& session) {
  if (session.planned || session.told.outcome != "running") return;
  session.planned = true;
  const StudyBundle* bundle = study_of(database, session.study_uuid);
  if (bundle == nullptr) return;
  const Plan plan = make_plan(bundle->study, session.sequence);
  session.told.trials = static_cast<int>(plan.trials.size());
  session.minutes_left = minutes_left(*bundle, registry_, plan, timed_people);
}

void Watch::tell(const std::string& now_utc) {
  now_.sessions.clear();
  for (const std::string& uuid : listed_) {
    WatchedSession told = told_of(*known_.at(uuid), now_utc);
    if (told.ended_s <= 3600 * listed_h) now_.sessions.push_back(std::move(told));
  }
  std::stable_sort(now_.sessions.begin(), now_.sessions.end(), comes_before);
}

}  // namespace promenade::study
