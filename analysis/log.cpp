#include "analysis/log.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/item.h"
#include "motion/problem.h"
#include "study/identity.h"
#include "study/migrate.h"
#include "study/prereg_seal.h"
#include "study/schema.h"
#include "study/sqlite.h"
#include "study/versions.h"

namespace promenade::analysis {
namespace {

using study::Database;
using study::Statement;

constexpr const char* session_query =
    "SELECT session.uuid, participant.uuid, participant.code, session.outcome, "
    "session.started_utc, session.simulated, session.pilot, study.study_sha256, "
    "session.station, session.sequence, session.resumed "
    "FROM session JOIN participant ON participant.uuid = session.participant "
    "JOIN study ON study.uuid = session.study "
    "ORDER BY session.started_utc, participant.code, session.uuid";
constexpr const char* trial_query =
    "SELECT session, uuid, position, task, interface, target, limit_s, threshold_m, started_us, "
    "ended_us, outcome, d_first, d_best, d_final, clicks, changes, coalesce(paused_us, 0), block, "
    "late_frames, seconds_difference, first_below_us, d_area_m_s, path_m, reversals, drags, "
    "controls_touched, examples_visited, map_coverage, idle_us, camera_moves "
    "FROM trial WHERE practice = 0 AND superseded = 0 AND interface <> '' "
    "ORDER BY session, position, uuid";
constexpr int first_process_column = 19;
// In the order of the key, so that one pass over the file is enough.
constexpr const char* event_query =
    "SELECT coalesce(trial, ''), actor, uncertainty_us, kind, session, coalesce(target, ''), "
    "coalesce(detail, ''), t_us FROM event WHERE (actor = 'participant' AND trial IS NOT NULL) "
    "OR (actor = 'system' AND kind = 'interrupted') OR actor = 'experimenter' OR kind = 'stop' "
    "ORDER BY session, seq";
constexpr const char* repeated_query =
    "SELECT session, count(*) FROM trial WHERE superseded = 1 AND practice = 0 "
    "AND interface <> '' GROUP BY session ORDER BY session";
constexpr const char* tombstone_query =
    "SELECT participant FROM tombstone WHERE removed = 'everything' ORDER BY participant";
constexpr const char* roster_query =
    "SELECT code, station, sequence, state, coalesce(replaces, '') FROM roster ORDER BY code";
// A choice has its name beside its place: it is counted, its place is no amount.
constexpr const char* answer_query =
    "SELECT trial, item, value, instrument FROM answer "
    "WHERE trial IS NOT NULL AND value IS NOT NULL AND declined = 0 AND touched = 1 "
    "AND coalesce(text, '') = '' ORDER BY trial, t_us, item";

// Nothing that is measured comes near it; squares and sums of what does would be infinite.
constexpr double largest_value = 1e100;

// SQLite stores infinities; they are counted in `dropped` and taken for missing.
std::optional<double> real(const Statement& row, int column, int& dropped) {
  if (row.is_null(column)) return std::nullopt;
  const double value = row.real(column);
  if (std::abs(value) < largest_value) return value;
  ++dropped;
  return std::nullopt;
}

// {"reason": "..."}; empty where there is none.
std::string reason_in(const std::string& detail) {
  const auto json = nlohmann::json::parse(detail, nullptr, false);
  const bool has_it = json.is_object() && json.contains("reason") && json["reason"].is_string();
  return has_it ? json["reason"].get<std::string>() : "";
}

LoggedTrial trial_in(const Statement& row, int session, int& dropped) {
  LoggedTrial trial;
  trial.session = session;
  trial.uuid = row.text(1);
  trial.position = static_cast<int>(row.integer(2));
  trial.task = row.text(3);
  trial.interface = row.text(4);
  trial.target = row.text(5);
  trial.limit_s = real(row, 6, dropped);
  trial.threshold_m = real(row, 7, dropped);
  trial.started_us = row.integer(8);
  if (!row.is_null(9)) trial.ended_us = row.integer(9);
  trial.outcome = row.text(10);
  trial.d_first = real(row, 11, dropped);
  trial.d_best = real(row, 12, dropped);
  trial.d_final = real(row, 13, dropped);
  trial.clicks = real(row, 14, dropped);
  trial.changes = real(row, 15, dropped);
  trial.paused_us = row.integer(16);
  trial.block = static_cast<int>(row.integer(17));
  trial.late_frames = real(row, 18, dropped);
  for (int i = 0; i < size_of(process_columns()); ++i) {
    trial.process.push_back(real(row, first_process_column + i, dropped));
  }
  return trial;
}

// Adds file after file to one log. A session counts in the first file that has it.
class Reader {
 public:
  void read(const std::string& file) {
    Database database = open_database(file);
    read(database);
  }

  void read(Database& database) {
    log_.files.push_back({database.file(), "", 0, 0, 0});
    read_study(database);
    read_sessions(database);
    read_trials(database);
    read_repeated(database);
    read_events(database);
    read_answers(database);
    read_roster(database);
    read_tombstones(database);
  }

  Log take() {
    tell_items_apart();
    count_versions();
    count_removed();
    return std::move(log_);
  }

 private:
  int file_index() const { return size_of(log_.files) - 1; }

  void read_study(Database& database) {
    const std::vector<study::StudyVersion> versions = study::study_versions(database);
    if (versions.empty()) throw InputError(database.file(), "holds no study");
    const study::StudyVersion& newest = versions.back();
    log_.files.back().program_version = newest.program_version;
    if (file_index() == 0) {
      log_.study = newest.name;
      log_.version = newest.version;
      log_.sha256 = newest.sha256;
      log_.config_text = newest.config_text;
    } else if (newest.sha256 != log_.sha256) {
      throw InputError(database.file(), "holds another study, or another version of it, than " +
                                            log_.files[0].file + "; report them one by one");
    }
    for (const study::StudyVersion& one : versions) add_version(database, one);
  }

  // The newest one is the same in all files and stays the last.
  void add_version(Database& database, const study::StudyVersion& one) {
    const int known = version_of(one.sha256);
    if (known < size_of(log_.versions)) {
      // A station that began with this version does not know why it came.
      LoggedVersion& version = item(log_.versions, known);
      if (version.amended_utc.empty()) {
        version.reason = one.reason;
        version.amended_utc = one.amended_utc;
      }
      return;
    }
    const bool first_file = file_index() == 0;
    LoggedVersion version{one.version, one.sha256, one.reason, one.amended_utc};
    const auto seal = study::seal_in(database, one.uuid, one.config_text);
    if (seal) version.seal = seal->sha256;
    version.unsealed_sha256 = study::sha256_hex(study::without_seal(one.config_text));
    log_.versions.insert(log_.versions.end() - (first_file ? 0 : 1), std::move(version));
  }

  int version_of(const std::string& sha256) const {
    const auto found =
        std::find_if(log_.versions.begin(), log_.versions.end(),
                     [&sha256](const LoggedVersion& one) { return one.sha256 == sha256; });
    return static_cast<int>(found - log_.versions.begin());
  }

  void read_sessions(Database& database) {
    Statement row(database, session_query);
    while (row.step()) {
      if (!session_of_.emplace(row.text(0), size_of(log_.sessions)).second) {
        ++log_.repeated_sessions;
        continue;
      }
      const int version = version_of(row.text(7));
      if (version == size_of(log_.versions)) {
        throw InputError(database.file(), study::damaged_database);
      }
      log_.sessions.push_back({row.text(0), row.text(1), row.text(2), row.text(3), row.text(4),
                               row.text(8), static_cast<int>(row.integer(9)),
                               static_cast<int>(row.integer(10)), row.integer(5) != 0,
                               row.integer(6) != 0, file_index(), version});
      ++log_.files.back().sessions;
    }
  }

  void read_trials(Database& database) {
    Statement row(database, trial_query);
    while (row.step()) {
      const int session = session_of_.at(row.text(0));
      if (item(log_.sessions, session).file != file_index()) continue;
      trial_of_.emplace(row.text(1), size_of(log_.trials));
      log_.trials.push_back(trial_in(row, session, log_.not_finite));
      ++log_.files.back().trials;
    }
  }

  void read_repeated(Database& database) {
    Statement row(database, repeated_query);
    while (row.step()) {
      LoggedSession& session = item(log_.sessions, session_of_.at(row.text(0)));
      if (session.file == file_index()) session.repeated_trials = static_cast<int>(row.integer(1));
    }
  }

  void read_events(Database& database) {
    Statement row(database, event_query);
    std::string uuid;
    int trial = -1;
    while (row.step()) {
      if (row.text_view(0) != uuid) {
        uuid = row.text(0);
        const auto found = trial_of_.find(uuid);
        const bool ours = found != trial_of_.end() && file_of_trial(found->second) == file_index();
        trial = ours ? found->second : -1;
      }
      take_quality(row, trial);
      if (row.text_view(1) == "experimenter" || row.text_view(3) == "stop") take_act(row, trial);
    }
  }

  void take_quality(const Statement& row, int trial) {
    if (trial < 0) return;
    LoggedTrial& logged = item(log_.trials, trial);
    if (row.text_view(1) == "participant") {
      logged.uncertainty_us = std::max(logged.uncertainty_us, row.integer(2));
    }
    logged.interruptions += row.text_view(3) == "interrupted" ? 1 : 0;
  }

  void take_act(const Statement& row, int trial) {
    const auto session = session_of_.find(row.text(4));
    if (session == session_of_.end()) return;
    if (item(log_.sessions, session->second).file != file_index()) return;
    const std::string kind = row.text(3);
    if (kind == "note") ++log_.notes;
    if (kind != "skip" && kind != "repeat" && kind != "release" && kind != "stop") return;
    if (kind == "skip" && trial < 0) trial = trial_skipped_at(session->second, row.integer(7));
    log_.acts.push_back({session->second, trial, kind, row.text(5), reason_in(row.text(6))});
  }

  // A trial that was skipped before it began, begins and ends at this very time.
  int trial_skipped_at(int session, std::int64_t t_us) const {
    const auto found =
        std::find_if(log_.trials.begin(), log_.trials.end(), [&](const LoggedTrial& trial) {
          return trial.session == session && trial.outcome == "skipped" && trial.started_us == t_us;
        });
    return found == log_.trials.end() ? -1 : static_cast<int>(found - log_.trials.begin());
  }

  void read_tombstones(Database& database) {
    Statement row(database, tombstone_query);
    while (row.step()) removed_.insert(row.text(0));
  }

  // One file may still hold who was removed from another.
  void count_removed() {
    for (const LoggedSession& session : log_.sessions) removed_.erase(session.participant);
    log_.removed_people = size_of(removed_);
  }

  // A code stands in one roster; what a station knows of it beats what was dealt.
  void read_roster(Database& database) {
    Statement row(database, roster_query);
    while (row.step()) {
      const LoggedPlace place{row.text(0), row.text(1), static_cast<int>(row.integer(2)),
                              row.text(3), row.text(4)};
      const auto known =
          std::find_if(log_.roster.begin(), log_.roster.end(),
                       [&place](const LoggedPlace& one) { return one.code == place.code; });
      if (known == log_.roster.end()) {
        log_.roster.push_back(place);
      } else if (known->state == "booked") {
        *known = place;
      }
    }
  }

  // Of trials in this file: the same answers stand in every file with their trial.
  void read_answers(Database& database) {
    Statement row(database, answer_query);
    while (row.step()) {
      const auto trial = trial_of_.find(row.text(0));
      if (trial == trial_of_.end() || file_of_trial(trial->second) != file_index()) continue;
      const auto value = real(row, 2, log_.not_finite);
      if (!value) continue;
      log_.answers.push_back({trial->second, row.text(1), value});
      instruments_.push_back(row.text(3));
      ++log_.files.back().answers;
    }
  }

  // Two instruments may ask an item of one name after trials: these are two measures.
  void tell_items_apart() {
    std::map<std::string, std::set<std::string>> askers;
    for (int i = 0; i < size_of(log_.answers); ++i) {
      askers[item(log_.answers, i).item].insert(item(instruments_, i));
    }
    for (int i = 0; i < size_of(log_.answers); ++i) {
      std::string& name = item(log_.answers, i).item;
      const std::string& instrument = item(instruments_, i);
      if (askers[name].size() > 1 && instrument != "rating") name = instrument + "." + name;
    }
  }

  void count_versions() {
    for (const LoggedSession& session : log_.sessions) {
      LoggedVersion& version = item(log_.versions, session.version);
      ++version.sessions;
      version.finished += session.outcome == "finished" ? 1 : 0;
    }
    for (const LoggedTrial& trial : log_.trials) {
      ++item(log_.versions, item(log_.sessions, trial.session).version).trials;
    }
  }

  int file_of_trial(int trial) const {
    const int session = item(log_.trials, trial).session;
    return item(log_.sessions, session).file;
  }

  Log log_;
  std::vector<std::string> instruments_;   // of the answers
  std::map<std::string, int> session_of_;  // uuid to index
  std::map<std::string, int> trial_of_;
  std::set<std::string> removed_;  // uuids of people
};

}  // namespace

const std::vector<std::string>& process_columns() {
  static const std::vector<std::string> names = {
      "seconds_difference", "first_below_us",   "d_area_m_s",   "path_m",  "reversals",   "drags",
      "controls_touched",   "examples_visited", "map_coverage", "idle_us", "camera_moves"};
  return names;
}

Database open_database(const std::string& file) {
  Database database = study::open_log(file);
  if (study::is_damaged(database, {"session", "trial", "answer"})) {
    throw InputError(file, study::damaged_database);
  }
  return database;
}

void refuse_content(const std::string& file, const study::DatabaseError& error) {
  if (error.about_content()) throw InputError(file, study::damaged_database);
  throw error;
}

Log read_log(Database& database) {
  Reader reader;
  reader.read(database);
  return reader.take();
}

Log read_log(const std::vector<std::string>& files) {
  Reader reader;
  std::vector<Problem> problems;
  for (const std::string& file : files) {
    try {
      reader.read(file);
    } catch (const InputError& error) {
      problems.insert(problems.end(), error.problems().begin(), error.problems().end());
    } catch (const study::DatabaseError& error) {
      if (!error.about_content()) throw;
      problems.push_back({file, 0, 0, study::damaged_database, Severity::error});
    }
  }
  if (!problems.empty()) throw InputError(std::move(problems));
  return reader.take();
}

std::vector<std::string> log_queries() {
  return {study::study_versions_query,
          session_query,
          trial_query,
          event_query,
          repeated_query,
          answer_query,
          roster_query,
          tombstone_query};
}

}  // namespace promenade::analysis
