// What was logged, as plain tables: the door from study/ to analysis/. Nothing
// is judged here; analysis/selection.h says who counts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace promenade::study {
class Database;
class DatabaseError;
}  // namespace promenade::study

namespace promenade::analysis {

struct LoggedSession {
  std::string uuid;
  std::string participant;  // uuid of the person
  std::string code;         // of the person, as the experimenter gave it
  std::string outcome;      // running, finished, declined, withdrawn or stopped
  std::string started_utc;
  std::string station;
  int sequence = 0;  // order of the plan
  int resumed = 0;   // how often it went on after an interruption
  bool simulated = false;
  bool pilot = false;
  int file = 0;             // index into Log::files
  int version = 0;          // index into Log::versions
  int repeated_trials = 0;  // that were done again later; practice apart
};

struct LoggedTrial {
  int session = 0;  // index into Log::sessions
  std::string uuid;
  int position = 0;  // in the session, from 1
  int block = 0;     // of the plan, from 1
  std::string task, interface, target;
  std::optional<double> limit_s, threshold_m;
  std::int64_t started_us = 0;
  std::optional<std::int64_t> ended_us;
  std::int64_t paused_us = 0;  // how long it stood still between them
  std::string outcome;         // success, timeout, done, skipped or aborted; empty: cut off
  std::optional<double> d_first, d_best, d_final;  // metres
  std::optional<double> clicks, changes;
  std::vector<std::optional<double>> process;  // one for each of process_columns(), as stored
  // Of its time stamps: how good they are, and whether the frames came as they should.
  std::optional<double> late_frames;
  std::int64_t uncertainty_us = 0;  // the largest of any input of the person
  int interruptions = 0;            // how often the program ended in it and went on
};

// The columns of `trial` that describe how a person worked, as the file names them: defined
// once for all interfaces (docs/analysts.md).
const std::vector<std::string>& process_columns();

struct LoggedAnswer {
  int trial = 0;  // index into Log::trials
  std::string item;
  std::optional<double> value;
};

// What the experimenter did in a session, or how it was stopped.
struct LoggedAct {
  int session = 0;     // index into Log::sessions
  int trial = -1;      // index into Log::trials; -1: outside trials, or one that does not count
  std::string kind;    // skip, repeat, release or stop
  std::string target;  // of repeat: trial or block
  std::string reason;  // as it was typed; empty: none
};

// A place of the roster, as the file knows it.
struct LoggedPlace {
  std::string code;
  std::string station;
  int sequence = 0;      // order of the plan
  std::string state;     // booked, done, no_show or replaced
  std::string replaces;  // the code whose place this is; empty: none
};

struct LoggedFile {
  std::string file;  // as it was named
  std::string program_version;
  int sessions = 0, trials = 0, answers = 0;  // rows taken from it
};

// Of the study: what it was at first, and each amendment.
struct LoggedVersion {
  std::string version, sha256;
  std::string reason, amended_utc;             // empty: the first
  int sessions = 0, finished = 0, trials = 0;  // rows taken, simulated ones and pilots included
  // SHA-256 of the preregistration that it names, and of its text without that name
  // (study/prereg_seal.h); `seal` is empty where it names none.
  std::string seal = {}, unsealed_sha256 = {};
};

struct Log {
  std::string study, version, sha256, config_text;
  std::vector<LoggedVersion> versions;  // the newest last: that is what stands above
  std::vector<LoggedFile> files;
  std::vector<LoggedSession> sessions;  // by file and start
  // Without practice, what was done again later, and rate tasks, which have no interface; by
  // session and position.
  std::vector<LoggedTrial> trials;
  std::vector<LoggedAnswer> answers;  // about these trials, touched and not declined
  std::vector<LoggedPlace> roster;    // each code once; empty: there was none
  std::vector<LoggedAct> acts;        // by file, session and time
  // People who withdrew and of whom nothing was kept: known by their tombstones alone.
  int removed_people = 0;
  int notes = 0;              // of experimenters, which only an export shows
  int repeated_sessions = 0;  // in more than one file, taken once
  int not_finite = 0;         // values that are infinite, taken for missing
};

// Reads databases of one study, read-only. Throws InputError, with the problems of
// all files at once, when one is missing, no database of Promenade, from a newer
// version, damaged (also where a row refers to one that is gone), or of another study
// than the first; the newest version decides.
Log read_log(const std::vector<std::string>& files);

// The same of one that is open.
Log read_log(study::Database& database);

// Opens a database of Promenade, read-only, whose rows are whole. Throws InputError as above,
// and DatabaseError, of which `refuse_content` knows more.
study::Database open_database(const std::string& file);

// A failure that is about the content of the file, not about the disk, becomes InputError.
[[noreturn]] void refuse_content(const std::string& file, const study::DatabaseError& error);

// The queries behind it, for people who want to repeat them.
std::vector<std::string> log_queries();

}  // namespace promenade::analysis
