// The sessions of a database, as a list for people to choose from.
#pragma once

#include <string>
#include <vector>

namespace promenade::study {

class Database;

struct ListedSession {
  std::string uuid, participant, station, started_utc, outcome;
  bool pilot = false, simulated = false;
  int trials = 0;  // that count, and were ended
};

// By their beginnings.
std::vector<ListedSession> list_sessions(Database& database);

}  // namespace promenade::study
