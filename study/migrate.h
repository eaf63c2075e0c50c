// Databases of older versions of the tables (schema.h). Whoever writes brings the file to
// this version, after a copy of it; whoever only reads leaves the file as it is.
#pragma once

#include <string>

#include "study/sqlite.h"

namespace promenade::study {

// Step by step to schema_version, all rows kept. The transaction is the caller's. Throws
// InputError where the tables are of no version that was ever released.
void migrate_tables(Database& database);

// Of a file that was opened for writing: when it is of an older version, a verified copy
// beside it first, FILE.v1.backup, for its owner only and never over another, which table
// `backup` then knows. Throws OutsideError when there is no room for it.
void migrate_file(Database& database);

// To read, with the tables of this version: the file itself, opened read-only, or a copy of
// an older one in memory. Throws InputError when there is none, it is no database of
// Promenade, of a newer version, or damaged.
Database open_log(const std::string& file, int wait_ms = 2000);

}  // namespace promenade::study
