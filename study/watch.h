// What the sessions in a database do at this moment, told from what is stored while another
// program writes it. Nobody waits for a watcher: the file is opened to read only, when it has
// changed, and closed again within milliseconds, so that its journal can be emptied; what a
// session has done so far is read once.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "study/file_stamp.h"
#include "study/interface.h"
#include "study/study.h"

namespace promenade::study {

class Database;
struct FollowedSession;

struct WatchedNote {
  std::int64_t t_us = 0;  // since the session began
  std::string text;
};

// What became of what a watcher asked for (study/control.h).
struct WatchedAnswer {
  std::string request;  // its id
  bool done = false;
  std::string why;  // not done: as study::Refused has it
};

// The trial that is on screen.
struct WatchedTrial {
  int position = 0;  // in the plan, from 1
  int attempt = 1;
  bool practice = false;
  std::string task, interface, target;         // names; no interface in rate tasks
  std::optional<double> limit_s, threshold_m;  // nothing: there is none
  double seconds = 0;                          // since it began, without pauses
  std::optional<double> left_s() const;        // of the limit
  struct Shown {
    double seconds = 0, d = 0;  // d: metres
  };
  std::vector<Shown> shown;      // by time; empty in tasks without a target motion
  std::optional<double> d_best;  // the smallest so far, metres
  int late_frames = 0;
};

enum class WatchedState { running, paused, left, interrupted, ended };
std::string_view to_text(WatchedState state);

struct WatchedSession {
  std::string uuid, participant, station, language, started_utc, ended_utc;
  bool simulated = false, pilot = false;
  WatchedState state = WatchedState::running;
  std::string outcome;  // as stored: "running", "finished", ...
  std::string page;     // to_text of its PageKind; empty: none was shown, or it has ended
  int page_index = -1;  // in the plan, from 0; -1: outside
  std::optional<WatchedTrial> trial;
  int trials_done = 0;                 // that count
  int trials = 0;                      // in the plan; 0: not known
  double minutes = 0;                  // played, without interruptions
  std::optional<double> minutes_left;  // about; nothing: not known, or it has ended
  double ended_s = 0;                  // since it ended; 0: it has not
  double silent_s = 0;                 // since the last sign of life of its program
  double still_s = 0;                  // since its last event
  std::int64_t frames = 0;             // in the trials that have ended; 0: none were counted
  int late_frames = 0;                 // of these
  std::vector<WatchedNote> notes;      // of a session that has not ended
  std::vector<WatchedAnswer> answers;  // since it is watched
};

struct Watched {
  std::string problem;          // why nothing new can be read, a sentence; empty: all is well
  bool is_input_error = false;  // the problem: the file is no database that can be watched
  bool waits = false;           // the problem: it is not there yet, or being made
  bool is_locked = false;       // the problem: another program holds it at this moment
  std::string study, version;   // of the newest version
  int planned = 0;              // participants; 0: not said
  int finished = 0;             // participants, neither pilot nor simulated
  int finished_pilot = 0, finished_simulated = 0;
  // Those that run, by start; then those that wait to be resumed, and those that ended in the
  // last 12 hours, the latest first.
  std::vector<WatchedSession> sessions;
};

class Watch {
 public:
  // The file need not be there yet. `registry` outlives the watch.
  Watch(std::string file, const InterfaceRegistry& registry);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // As it is when it is `now_utc`. Whatever the file is, nothing is thrown: see `problem`.
  const Watched& look(const std::string& now_utc);

 private:
  void refresh(const std::string& now_utc);
  void read(const std::string& now_utc);
  void read_study(Database& database);
  void read_sessions(Database& database, const std::string& now_utc);
  void plan(Database& database, FollowedSession& session);
  const StudyBundle* study_of(Database& database, const std::string& uuid);
  void forget();
  void tell(const std::string& now_utc);

  std::string file_;
  const InterfaceRegistry& registry_;
  DatabaseStamp stamp_;  // when it was read
  bool calm_ = false;    // it was read once more since it has changed
  std::map<std::string, std::unique_ptr<FollowedSession>> known_;  // by uuid
  std::vector<std::string> listed_;                                // uuids, by start
  std::map<std::string, std::unique_ptr<StudyBundle>> studies_;    // null: it cannot be read
  std::string newest_;                                             // uuid of a study
  Watched now_;
};

}  // namespace promenade::study
