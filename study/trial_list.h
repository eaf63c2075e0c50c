// The trials of a database in one list, to choose one from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace promenade::study {

class Database;

struct ListedTrial {
  std::string uuid, session, participant;
  bool simulated = false, pilot = false, practice = false;
  int position = 0;  // in the plan, from 1
  int attempt = 1;
  bool superseded = false;  // it was done again, and does not count
  std::string task, interface, target;
  std::string outcome;            // empty: it has not ended
  std::optional<double> seconds;  // without pauses; nothing: it has not ended
  std::optional<double> d_final;  // metres; nothing in tasks without a target motion
  double ended_s = 0;             // by the wall clock, since an epoch; 0: it has not ended
};

// By session, and within one by start.
std::vector<ListedTrial> list_trials(Database& database);

// That with this uuid, or without one the trial that ended last. Throws InputError when there
// is none.
ListedTrial choose_trial(Database& database, const std::string& uuid);

}  // namespace promenade::study
