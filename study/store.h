// The log of sessions in SQLite: one file per study and station, WAL.
//
// write() puts what one step of the session returned into the open transaction, as a whole
// or not at all, so that a replay of the file ends between two steps; flush() commits without
// waiting for the disk (it survives a kill of the program) and belongs into the frame, at
// least every 50 ms; a step that ends a trial, or
// decides or ends the session, is committed durably at once (it
// survives a power cut). Checkpoints run between trials only.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "study/frame_histogram.h"
#include "study/session.h"
#include "study/session_log.h"

namespace promenade::study {

class Database;

struct SessionHeader {
  std::string participant;  // code
  std::string station = "1";
  std::string language = "en";
  bool simulated = false, pilot = false;
  std::string machine = "{}";    // JSON
  std::string started_utc;       // ISO 8601
  bool new_participant = false;  // the code must not have been used before
};

// Nobody ended it and no process runs it: it can be resumed.
struct InterruptedSession {
  std::string uuid, participant, station, started_utc;
  int trial = 0;             // position of the trial that began last, from 1; 0: none
  std::int64_t last_us = 0;  // of its last event
  bool left = false;         // the person left, to go on another day
};

// Somebody else, most likely another process, has what this session was to get.
class TakenError : public OutsideError {
 public:
  enum class What { sequence, code, session };
  TakenError(What what, const std::string& message) : OutsideError(message), what_(what) {}
  What taken() const { return what_; }

 private:
  What what_;
};

class Store {
 public:
  // Opens the file or makes it, and puts the study and its motion set in. Throws
  // InputError when the file belongs to another program or another study, and
  // OutsideError when it cannot be written.
  Store(const std::filesystem::path& file, const StudyBundle& bundle);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // The order that the next session gets: the one that is most missing among the sessions of
  // the same kind (real, pilot, simulated) that count (study/assignment.h), in this version of
  // the study or in one whose orders are the same (study/amend.h). Another process may take it
  // before begin_session.
  int next_sequence(bool simulated, bool pilot);
  // The same for the next `count` sessions, if all of them finish.
  std::vector<int> next_sequences(bool simulated, bool pilot, int count);
  bool knows_participant(const std::string& code);
  // "S001", "S002", ...: the next free code of a simulated participant.
  std::string next_simulated_code();
  int next_simulated_number();  // its number, from 1

  // Sessions of this study and kind that nobody ended and no process runs, the latest first.
  std::vector<InterruptedSession> interrupted_sessions(bool simulated, bool pilot);
  LoggedSession read_session(const std::string& uuid);

  // Writes a line into `file` (a pipe, most likely) for each event as it is put into the
  // transaction and for each trial that has become durable: how a test that kills the program
  // knows what there was to lose. Lines are "event SESSION SEQ" and "trial UUID".
  void trace_to(const std::string& file);

  // Throws TakenError, and stores nothing, when the order of the plan is no longer free,
  // or the code of a participant who must be new; OutsideError when the study was amended.
  // `first` is what the session has returned so far: it is stored with the session or not at all.
  void begin_session(const SessionHeader& header, const Plan& plan,
                     const std::vector<Record>& first = {});
  // Goes on with a session that was interrupted; `plan` is the one that it had. Throws
  // TakenError when another process goes on with it already.
  void resume_session(const LoggedSession& session, const Plan& plan);
  void write(const std::vector<Record>& step);
  // The program lives at this time of the session; put into the transaction once a second, so
  // that time in which nothing was done is not lost with it. True: this time it was.
  bool alive(std::int64_t t_us);
  // How the frames of a trial (an index into Plan::trials; -1: outside) were shown.
  void write_frames(int trial, const FrameHistogram& frames);
  void flush();
  const std::string& session() const;  // uuid of the one that runs; empty: none has begun
  void end_session(const std::string& ended_utc);

  // Where it all is, for whoever reads it in between: the only way to one in ":memory:".
  Database& database();

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

// Takes away a database in which no session ever began, for whoever made it in vain.
void remove_unused_store(const std::filesystem::path& file);

}  // namespace promenade::study
