// A study out of a database that holds its sessions: its text, the files that it names and
// the very motions, whatever has become of the files since.
#pragma once

#include <optional>
#include <vector>

#include "study/study.h"

namespace promenade::study {

class Database;

// Throws InputError when the database does not hold it whole, or this program cannot read
// it any more. Its hash may differ from the stored one when the texts or the interfaces of
// the program have changed; `sha256` is the stored one.
StudyBundle read_stored_study(Database& database, const std::string& study_uuid,
                              const InterfaceRegistry& registry);

// The instruments of all versions of the study alone, the newest version first: each name and
// version once. One that this program cannot read any more is not among them. Of [[rating]]
// the names of the items are known, and that they are scales.
std::vector<Instrument> stored_instruments(Database& database);

// The newest version. Nothing where the database has none, or this program cannot read it.
std::optional<StudyBundle> read_newest_study(Database& database, const InterfaceRegistry& registry);

}  // namespace promenade::study
