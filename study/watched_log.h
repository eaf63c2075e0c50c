// A session followed through its log as that grows: what a watcher has to remember of it. Inside
// study/ only.
#pragma once

#include "study/watch.h"

namespace promenade::study {

class Database;

// The trial that began last.
struct FollowedTrial {
  std::string uuid;
  std::int64_t started_us = 0;
  bool runs = false;
  WatchedTrial told;
  struct Stand {
    std::int64_t from_us = 0, length_us = 0;
  };
  std::vector<Stand> stands;               // pauses that are over
  std::int64_t last_row = 0, last_us = 0;  // of the samples that were read

  double seconds_at(std::int64_t t_us) const;  // without the pauses
};

struct FollowedSession {
  WatchedSession told;  // the header, and what follows from the log alone
  std::string study_uuid, process_start;
  std::int64_t process = 0;
  int sequence = 0;
  bool settled = false;  // it has ended, and nothing more is to be read

  std::int64_t seq = 0;                     // of the last event that was read
  std::int64_t event_us = 0, alive_us = 0;  // of that; of the last sign of life
  double gaps_s = 0;                        // interruptions, by the wall clock
  int place = -1;                           // of the page in the plan, from 0; -1: outside
  std::int64_t page_us = 0;                 // when it opened, moved by its pauses
  std::optional<std::int64_t> stands_since_us;
  bool left = false;
  FollowedTrial trial;

  std::vector<double> minutes_left;  // from each page of the plan on; empty: not known
  bool planned = false;              // it was asked for

  // The time of the session that its page has reached.
  std::int64_t reached_us() const { return stands_since_us ? *stands_since_us : alive_us; }
};

// What is new in the log; all in one transaction of the caller's.
void follow(Database& database, FollowedSession& session);

// As it is when it is `now_utc`.
WatchedSession told_of(const FollowedSession& session, const std::string& now_utc);

}  // namespace promenade::study
