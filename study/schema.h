// The tables of a study's database (docs/commands.md) and the sentence that
// describes each column.
#pragma once

#include <string>
#include <vector>

namespace promenade::study {

class Database;

inline constexpr int application_id = 0x50524d44;  // "PRMD"
inline constexpr int schema_version = 2;           // PRAGMA user_version

// What is said of a file that was a database once.
inline constexpr const char* damaged_database =
    "is damaged (cut off or overwritten); use a copy of it, or recover it with sqlite3's .recover";

// Makes all tables in an empty database and fills `dictionary`. The transaction is
// the caller's.
void create_tables(Database& database);

// The tables and indices of this version that are not there; columns are not looked at.
void make_missing_tables(Database& database);

int version_of(Database& database);  // of its tables

// Nothing is in it yet: whoever made it was killed, or has yet to fill it.
bool is_blank(Database& database);

// Pages that are no part of a database, or rows of these tables that refer to rows that are
// gone. Reads the whole file.
bool is_damaged(Database& database, const std::vector<std::string>& tables);

// Writes the sentence of every column into `dictionary`, over what stands there.
void fill_dictionary(Database& database);

// Throws InputError when the file is no database of Promenade, or of a newer
// version. Opens nothing for writing.
void check_database(Database& database);

}  // namespace promenade::study
