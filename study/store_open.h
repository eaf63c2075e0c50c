// Opens the database of a study, or makes it. Inside study/ only.
#pragma once

#include <filesystem>

#include "study/sqlite.h"
#include "study/study.h"

namespace promenade::study {

// Ready for writing: WAL, no automatic checkpoints, NORMAL. Errors as Store's.
Database open_store(const std::filesystem::path& file, const StudyBundle& bundle);

}  // namespace promenade::study
