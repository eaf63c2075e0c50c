// Opens the database of a study, or makes it. Inside study/ only.
#pragma once

#include <filesystem>

#include "study/sqlite.h"
#include "study/study.h"

namespace promenade::study {

// Ready for writing: WAL, no automatic checkpoints, NORMAL. Errors as Store's.
Database open_store(const std::filesystem::path& file, const StudyBundle& bundle);

// The database of a study that is there. Throws InputError when it is no database of a study,
// OutsideError when it cannot be written.
Database open_existing_store(const std::filesystem::path& file);

// Its uuid; it is put in, with its motions and parts, when it is not there yet. The
// transaction is the caller's.
std::string put_study(Database& database, const StudyBundle& bundle);

}  // namespace promenade::study
