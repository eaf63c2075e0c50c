// A running study, changed: from now on its sessions are of the new version, in the same
// database. The versions before stay in it, and their sessions theirs.
#pragma once

#include <filesystem>
#include <string>

#include "study/study.h"

namespace promenade::study {

// Have both the same order of interfaces for every number of the plan? Then who finished an
// order before counts for the balance of the changed study, too: the names of the interfaces,
// in the order of the file, and how they are counterbalanced decide, whatever else changed.
bool same_orders(const Study& before, const Study& after);

struct Amended {
  std::string previous_version;
  bool same_orders = false;
  int interrupted = 0;  // sessions of the version before that cannot be resumed any more
};

// Puts the changed study into the database of its sessions, with a reason and the date, as a
// whole or not at all. Throws InputError when there is no reason, no such database, nothing
// changed, the database holds another study, or held this very version before; OutsideError
// when a session runs now, or the database cannot be written.
Amended amend_study(const std::filesystem::path& database, const StudyBundle& changed,
                    const InterfaceRegistry& registry, const std::string& reason);

}  // namespace promenade::study
