// Opens the database of a study, or makes it. Inside study/ only.
#pragma once

#include <filesystem>

#include "study/sqlite.h"
#include "study/study.h"

namespace promenade::study {

// Ready for writing: WAL, no automatic checkpoints, NORMAL. Errors as Store's.
Database open_store(const std::filesystem::path& file, const StudyBundle& bundle);

// The same for a database that is there, whatever study it holds. Throws InputError as
// open_log does, and OutsideError when it must not be written.
Database open_existing_store(const std::string& file);

// Its uuid; it is put in, with its motions and parts, when it is not there yet. The
// transaction is the caller's.
std::string put_study(Database& database, const StudyBundle& bundle);

}  // namespace promenade::study
