// What an experimenter asks of a running session from another process. A watcher never writes the
// tables of a study: it appends a line to the file DB.control beside the database, and the session
// reads that between its frames, does it as the experimenter, and logs it with the id of the
// request. So the log alone says what was asked, what was done, and what was refused.
//
// A line is one JSON object:
//   {"id": "...", "session": UUID, "do": "skip", "reason": "...", "page": 7,
//    "written_utc": "2026-11-22T16:02:29Z"}
// "do" is pause, resume, skip, repeat (with "block": true or false), note, release or stop. Skip,
// repeat and stop need a "reason", a note its "text". "page" is optional: the place in the plan
// that the asker saw; where the session is elsewhere by now, it refuses.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "study/session.h"

namespace promenade::study {

struct Request {
  std::string id;       // letters, digits and hyphens; comes back in the event's detail
  std::string session;  // uuid of the one that is asked
  std::string what;     // "pause", ...; "unknown": a word that this version does not know
  std::string words;    // the reason, or the note
  bool block = false;   // repeat: the whole block
  int page = -1;        // index into Plan::pages; -1: wherever it is
  std::string written_utc;
};

// Longer words are cut.
inline constexpr int most_request_characters = 500;
// A session that finds an older request refuses it: who asked has given up by then.
inline constexpr std::int64_t oldest_request_s = 5;

std::string requests_file(const std::string& database);

// As it stands in the file, with the end of the line.
std::string line_of(const Request& request);
// Nothing: the line is broken.
std::optional<Request> read_request(std::string_view line);
// What a session does about it. Nothing: it cannot be done, for want of words or knowledge.
std::optional<decltype(Input::action)> action_of(const Request& request);

// Appends it, as a whole or not at all, to a file with the rights of the database. Throws
// OutsideError.
void ask(const std::string& database, const Request& request);

// Nobody is left to read it: what was asked may speak of people.
void remove_requests(const std::string& database);

// The session's end of it: each request once, and none from before it was made.
class RequestReader {
 public:
  explicit RequestReader(const std::string& database);
  ~RequestReader();
  RequestReader(const RequestReader&) = delete;
  RequestReader& operator=(const RequestReader&) = delete;

  struct News {
    std::vector<Request> asked, late;  // late: too old to be done
    bool broken = false;               // a line could not be read; said once
  };
  // Is there anything that was not read yet? Costs a stat and no memory.
  bool waiting();
  // What is new for the session of this uuid. Never waits, and throws nothing, whatever lies there.
  News take(const std::string& session, const std::string& now_utc);

 private:
  bool reopen();  // false: there is no such file
  void read(News& news, const std::string& session, const std::string& now_utc);
  void sort_in(std::string_view line, News& news, const std::string& session,
               const std::string& now_utc);

  std::string file_;
  int handle_ = -1;  // stays open, so that another file cannot come by its inode
  std::int64_t offset_ = 0, size_ = 0;
  std::string rest_;    // a line that has not ended yet
  bool skips_ = false;  // the line that goes on is too long, or began before
  bool had_broken_ = false;
  std::set<std::string> seen_;  // ids
};

}  // namespace promenade::study
