// Databases of made-up people for the tests: the tables that the program makes,
// filled row by row.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>

#include "study/schema.h"
#include "study/sqlite.h"
#include "tests/test_folder.h"

namespace promenade::analysis {

struct ToyTrial {
  std::string interface = "labels";
  std::string target = "happy";
  double seconds = 10;
  std::optional<double> d_final = 0.05;
  std::string outcome = "done";  // empty: cut off
  std::string task = "match";
  bool practice = false;
  std::optional<double> limit_s = 60;
  std::optional<double> threshold_m = {};
};

struct ToySession {
  std::string code = "P01";
  std::string outcome = "finished";
  bool simulated = false, pilot = false;
};

class ToyLog {
 public:
  explicit ToyLog(const std::string& file, const std::string& hash = "abc")
      : database_(file, study::Database::Mode::create) {
    database_.exec("PRAGMA synchronous = OFF");
    study::create_tables(database_);
    insert("study(uuid, name, version, config_text, study_sha256, program_version, created_utc)",
           {"study-" + hash, "Walks", "1", config, hash, "0.1.0", "2026-11-22T10:00:00Z"});
  }

  // The trials that follow belong to this session. Uuids start with `prefix`.
  ToyLog& session(const ToySession& session, const std::string& prefix = "") {
    prefix_ = prefix + std::to_string(++sessions_);
    study::Statement person(database_, "INSERT OR IGNORE INTO participant VALUES (?,?)");
    person.bind(1, prefix + session.code).bind(2, session.code).run();
    study::Statement row(database_,
                         "INSERT INTO session(uuid, study, participant, station, seed, sequence, "
                         "language, started_utc, outcome, simulated, pilot, machine) "
                         "SELECT ?, uuid, ?, '1', 1, 0, 'en', ?, ?, ?, ?, '{}' FROM study");
    row.bind(1, prefix_).bind(2, prefix + session.code);
    row.bind(3, "2026-11-22T11:00:" + std::to_string(10 + sessions_)).bind(4, session.outcome);
    row.bind(5, session.simulated).bind(6, session.pilot).run();
    position_ = 0;
    return *this;
  }

  ToyLog& trial(const ToyTrial& trial) {
    study::Statement row(database_,
                         "INSERT INTO trial (uuid, session, position, block, practice, task, "
                         "interface, target, limit_s, threshold_m, started_us, ended_us, outcome, "
                         "d_first, d_best, d_final, clicks, changes) "
                         "VALUES (?,?,?,1,?,?,?,?,?,?,0,?,?,0.1,?,?,7,9)");
    ++position_;
    row.bind(1, trial_uuid(position_)).bind(2, prefix_).bind(3, position_).bind(4, trial.practice);
    row.bind(5, trial.task).bind(6, trial.interface).bind(7, trial.target).bind(8, trial.limit_s);
    row.bind(9, trial.threshold_m).bind(10, static_cast<std::int64_t>(trial.seconds * 1e6));
    if (trial.outcome.empty()) {
      row.bind_null(11);
    } else {
      row.bind(11, trial.outcome);
    }
    row.bind(12, trial.d_final).bind(13, trial.d_final).run();
    return *this;
  }

  // About the trial before.
  ToyLog& answer(const std::string& item, double value, bool touched = true) {
    study::Statement row(database_,
                         "INSERT INTO answer(session, trial, instrument, version, item, value, "
                         "declined, touched, t_us) VALUES (?,?,'rating','1',?,?,0,?,?)");
    row.bind(1, prefix_).bind(2, trial_uuid(position_)).bind(3, item).bind(4, value);
    row.bind(5, touched).bind(6, ++answers_).run();
    return *this;
  }

  study::Database& database() { return database_; }

  static constexpr const char* config =
      "[[interface]]\ntype = \"weights\"\n[[interface]]\nname = \"labels\"\ntype = \"list\"\n"
      "[[task]]\nname = \"match\"\n";

 private:
  std::string trial_uuid(int position) const { return prefix_ + "/" + std::to_string(position); }

  void insert(const std::string& table, const std::vector<std::string>& values) {
    std::string marks;
    for (std::size_t i = 0; i < values.size(); ++i) marks += i > 0 ? ",?" : "?";
    study::Statement row(database_, "INSERT INTO " + table + " VALUES (" + marks + ")");
    for (std::size_t i = 0; i < values.size(); ++i) row.bind(static_cast<int>(i) + 1, values[i]);
    row.run();
  }

  study::Database database_;
  std::string prefix_;
  int sessions_ = 0, position_ = 0, answers_ = 0;
};

// `people` finish one trial per interface: labels d = 0.01 i + 0.02 and 10 + i s,
// weights d = 0.01 i + 0.02 + step i and 20 + i s, i = 1..people.
inline void fill(ToyLog& log, int people, double step, const std::string& prefix = "") {
  for (int i = 1; i <= people; ++i) {
    log.session({"P" + std::to_string(i)}, prefix);
    log.trial({"labels", "happy", 10.0 + i, 0.01 * i + 0.02});
    log.trial({"weights", "happy", 20.0 + i, 0.01 * i + 0.02 + step * i});
  }
}

}  // namespace promenade::analysis
