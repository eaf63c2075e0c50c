// Databases as released versions of the program made them, from tests/study/old.
#pragma once

#include "motion/files.h"
#include "study/sqlite.h"
#include "tests/source_dir.h"

namespace promenade::study {

inline void make_old_database(const std::string& file, int version) {
  Database(file, Database::Mode::create)
      .exec(read_file(source_dir() / "tests/study/old" / ("v" + std::to_string(version) + ".sql")));
}

}  // namespace promenade::study
