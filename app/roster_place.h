// The place of a participant in a roster, as `run --roster` takes it.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

// What the welcome page is told of a code.
struct RosterAnswer {
  enum class Kind { welcome, unknown, taken };
  Kind kind = Kind::unknown;
  study::RosterRow row = {};  // of who is welcome
};
// The same of who types the code on that page; for `taken` the reason goes to stderr. Throws
// OutsideError when the roster or the database cannot be read.
RosterAnswer ask_roster(const RosterCheck& check);

// The first who is expected at this station and has not come, for a simulated participant.
// Throws InputError when there is none.
study::RosterRow next_place(RosterCheck check);

// Puts the row of this code into the database, as done when the session finished. A code that is
// not in the roster has none: its session was begun without it.
void store_place(const RosterCheck& check, study::Outcome outcome);

}  // namespace promenade::app
