// A session as it stands in a database, read back in the order in which it was written: what
// a replay, an audit and a resume are made of.
#pragma once

#include <string>
#include <vector>

#include "study/session.h"

namespace promenade::study {

class Database;

struct LoggedTrial {
  std::string uuid;
  int position = 0;  // in the plan, from 1
  int attempt = 1;
  bool superseded = false;
  std::string task, interface, target;
  std::int64_t started_us = 0;
  std::string outcome;  // empty: it has not ended
  std::optional<double> d_first;
  TrialEnded ended;  // as stored; outcome apart
};

// A row of `event` or of `sample`; of a sample only what was shown is known.
struct LoggedStep {
  bool sample = false;
  int trial = -1;  // index into LoggedSession::trials; -1: outside trials
  Event event;     // its `trial` is not set
  Sample shown;    // its `trial` is not set

  std::int64_t t_us() const { return sample ? shown.t_us : event.t_us; }
};

struct LoggedSession {
  std::string uuid, study_uuid, participant, station, language, outcome, started_utc;
  std::string machine;  // JSON; "width" and "height" of the window in pixels, where there was one
  bool simulated = false, pilot = false;
  int sequence = 0;
  std::uint64_t seed = 0;
  std::vector<LoggedTrial> trials;  // by start; a repeated trial stands once an attempt
  std::vector<LoggedStep> steps;    // in the order of the log
  std::vector<Answer> answers;      // in the order of the log; what they are about is left out
  std::int64_t last_seq = 0;
  std::int64_t last_us = 0;  // of its last row, or until when the program is known to have lived
};

// Throws InputError when there is no such session, or its rows are damaged.
LoggedSession read_session(Database& database, const std::string& uuid);

// How long the session has stood by the wall clock when it is `now_utc`: since its last event,
// and without the gaps before. At least 0, whatever became of the clock.
std::int64_t gap_us(const LoggedSession& session, const std::string& now_utc);

// The uuids of all sessions, by start.
std::vector<std::string> session_uuids(Database& database);

}  // namespace promenade::study
