// Verified copies of a database: whole, for their owner only, written beside and renamed, and
// known to table `backup`, so that a withdrawal reaches them.
#pragma once

#include <optional>
#include <string>

#include "study/sqlite.h"

namespace promenade::study {

struct StudyBundle;

// Over what is at `path`: the file as it is now, on a connection of its own; others may go on
// with it. Throws OutsideError when it cannot be written or is not what was copied; the old
// copy stays then.
void copy_database(const std::string& file, const std::string& path);

// The copy at `path` is as the database is now.
void note_backup(Database& database, const std::string& path);

// Where the second copy of a database goes: `copy_to` of the study, from the folder of its
// file, /NAME-STATION.db. Empty: the study asks for none.
std::string second_copy_path(const StudyBundle& bundle, const std::string& file,
                             const std::string& station);

// Renews the second copy after a session; nothing is thrown. The problem in one sentence, for
// the experimenter: the session is safe in `file`, but not yet twice. It opens the file on its
// own and may run beside the store, in another thread.
std::optional<std::string> second_copy_problem(const StudyBundle& bundle, const std::string& file,
                                               const std::string& station);

}  // namespace promenade::study
