// The place of a participant in a roster, as `run --roster` takes it.
#pragma once

#include <string>

#include "study/roster.h"
#include "study/session.h"

namespace promenade::app {

struct RosterCheck {
  std::string roster;       // file
  std::string participant;  // the code as it was typed
  std::string station;      // where the person is
  std::string database;     // may not be there yet
  bool simulated = false;
};

// The row of the participant; a warning goes to stderr when another station expects them.
// Throws InputError when the code is not in the roster, or its place is taken.
study::RosterRow roster_place(const RosterCheck& check);

// Puts the row into the database, as done when the session finished.
void store_place(const std::string& database, study::RosterRow row, study::Outcome outcome);

}  // namespace promenade::app
