#include "study/schema.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "study/sqlite.h"

namespace promenade::study {
namespace {

constexpr const char* tables_sql = R"sql(
CREATE TABLE IF NOT EXISTS study(
  uuid TEXT PRIMARY KEY, name TEXT NOT NULL, version TEXT NOT NULL, config_text TEXT NOT NULL,
  study_sha256 TEXT NOT NULL UNIQUE, program_version TEXT NOT NULL, created_utc TEXT NOT NULL,
  motion_set TEXT REFERENCES motion_set(uuid)
) STRICT;
CREATE TABLE IF NOT EXISTS motion_set(
  uuid TEXT PRIMARY KEY, name TEXT NOT NULL, sha256 TEXT NOT NULL UNIQUE, content BLOB NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS study_part(
  study TEXT NOT NULL REFERENCES study(uuid), path TEXT NOT NULL, content BLOB NOT NULL,
  PRIMARY KEY (study, path)
) STRICT, WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS amendment(
  study TEXT PRIMARY KEY REFERENCES study(uuid), previous TEXT NOT NULL REFERENCES study(uuid),
  reason TEXT NOT NULL, amended_utc TEXT NOT NULL,
  same_orders INTEGER NOT NULL DEFAULT 0 CHECK (same_orders IN (0,1))
) STRICT;
CREATE TABLE IF NOT EXISTS participant(
  uuid TEXT PRIMARY KEY, code TEXT NOT NULL UNIQUE
) STRICT;
CREATE TABLE IF NOT EXISTS session(
  uuid TEXT PRIMARY KEY, study TEXT NOT NULL REFERENCES study(uuid),
  participant TEXT NOT NULL REFERENCES participant(uuid), station TEXT NOT NULL,
  seed INTEGER NOT NULL, sequence INTEGER NOT NULL, language TEXT NOT NULL,
  started_utc TEXT NOT NULL, ended_utc TEXT,
  outcome TEXT NOT NULL CHECK (outcome IN ('running','finished','declined','withdrawn','stopped')),
  simulated INTEGER NOT NULL CHECK (simulated IN (0,1)),
  pilot INTEGER NOT NULL CHECK (pilot IN (0,1)), process INTEGER, machine TEXT NOT NULL,
  process_start TEXT, resumed INTEGER NOT NULL DEFAULT 0, alive_us INTEGER
) STRICT;
CREATE INDEX IF NOT EXISTS session_by_order ON session(simulated, pilot, sequence);
CREATE TABLE IF NOT EXISTS trial(
  uuid TEXT PRIMARY KEY, session TEXT NOT NULL REFERENCES session(uuid),
  position INTEGER NOT NULL, block INTEGER NOT NULL, practice INTEGER NOT NULL CHECK (practice IN (0,1)),
  task TEXT NOT NULL, interface TEXT NOT NULL, target TEXT NOT NULL, limit_s REAL,
  threshold_m REAL, started_us INTEGER NOT NULL, ended_us INTEGER,
  outcome TEXT CHECK (outcome IN ('success','timeout','done','skipped','aborted')),
  d_first REAL, d_best REAL, d_final REAL, d_sum REAL, seconds_difference REAL,
  first_below_us INTEGER, paused_us INTEGER, clicks INTEGER, changes INTEGER,
  late_frames INTEGER, attempt INTEGER NOT NULL DEFAULT 1,
  superseded INTEGER NOT NULL DEFAULT 0 CHECK (superseded IN (0,1)),
  d_area_m_s REAL, path_m REAL, reversals INTEGER, drags INTEGER, controls_touched INTEGER,
  examples_visited INTEGER, map_coverage REAL, idle_us INTEGER, camera_moves INTEGER
) STRICT;
CREATE INDEX IF NOT EXISTS trial_by_session ON trial(session, position);
CREATE TABLE IF NOT EXISTS event(
  session TEXT NOT NULL REFERENCES session(uuid), trial TEXT REFERENCES trial(uuid),
  seq INTEGER NOT NULL, t_us INTEGER NOT NULL, uncertainty_us INTEGER NOT NULL,
  frame_us INTEGER, actor TEXT NOT NULL CHECK (actor IN ('participant','system','experimenter')),
  kind TEXT NOT NULL, target TEXT, value REAL, x REAL, y REAL, detail TEXT,
  PRIMARY KEY (session, seq)
) STRICT, WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS sample(
  trial TEXT NOT NULL REFERENCES trial(uuid), t_us INTEGER NOT NULL, d REAL, weights BLOB NOT NULL,
  after_seq INTEGER
) STRICT;
CREATE INDEX IF NOT EXISTS sample_by_trial ON sample(trial, t_us);
CREATE TABLE IF NOT EXISTS answer(
  session TEXT NOT NULL REFERENCES session(uuid), trial TEXT REFERENCES trial(uuid),
  instrument TEXT NOT NULL, version TEXT NOT NULL, item TEXT NOT NULL, value REAL, text TEXT,
  declined INTEGER NOT NULL CHECK (declined IN (0,1)),
  touched INTEGER NOT NULL CHECK (touched IN (0,1)), t_us INTEGER NOT NULL,
  asked TEXT, about TEXT REFERENCES trial(uuid), block INTEGER, task TEXT, interface TEXT,
  place INTEGER
) STRICT;
CREATE INDEX IF NOT EXISTS answer_by_session ON answer(session);
CREATE TABLE IF NOT EXISTS frame_histogram(
  session TEXT NOT NULL REFERENCES session(uuid), trial TEXT REFERENCES trial(uuid),
  measure TEXT NOT NULL CHECK (measure IN ('interval','work')),
  least_us INTEGER NOT NULL, count INTEGER NOT NULL
) STRICT;
CREATE INDEX IF NOT EXISTS frame_histogram_by_session ON frame_histogram(session);
CREATE TABLE IF NOT EXISTS roster(
  code TEXT PRIMARY KEY, station TEXT NOT NULL, sequence INTEGER NOT NULL,
  state TEXT NOT NULL CHECK (state IN ('booked','done','no_show','replaced')),
  replaces TEXT, changed_utc TEXT NOT NULL
) STRICT, WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS tombstone(
  participant TEXT PRIMARY KEY, withdrawn_utc TEXT NOT NULL,
  removed TEXT NOT NULL CHECK (removed IN ('everything','link'))
) STRICT, WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS backup(
  path TEXT PRIMARY KEY, made_utc TEXT NOT NULL, withdrawal_due_utc TEXT
) STRICT, WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS receipt(
  source TEXT NOT NULL, sha256 TEXT NOT NULL, merged_utc TEXT NOT NULL, rows_taken TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS dictionary(
  table_name TEXT NOT NULL, column_name TEXT NOT NULL, unit TEXT NOT NULL, meaning TEXT NOT NULL,
  PRIMARY KEY (table_name, column_name)
) STRICT, WITHOUT ROWID;
)sql";

std::int64_t pragma(Database& database, const char* name) {
  Statement statement(database, std::string("PRAGMA ") + name);
  return statement.step() ? statement.integer(0) : 0;
}

std::uint64_t number_in(std::string_view bytes) {  // big-endian
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << 8U | static_cast<unsigned char>(byte);
  return number;
}

// A file of SQLite that is shorter than its first bytes say (https://sqlite.org/fileformat.html).
bool is_cut(const std::string& file) {
  constexpr std::string_view magic = "SQLite format 3";
  std::string head(100, '\0');
  std::ifstream(file, std::ios::binary)
      .read(head.data(), static_cast<std::streamsize>(head.size()));
  if (head.compare(0, magic.size(), magic) != 0) return false;
  const std::string_view bytes = head;
  const std::uint64_t page = number_in(bytes.substr(16, 2));  // 1: 65536
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  return error || size < 512 || size < (page == 1 ? 65536 : page) * number_in(bytes.substr(28, 4));
}

[[noreturn]] void refuse_stranger(const std::string& file, const char* reason) {
  throw InputError(file, is_cut(file) ? damaged_database : reason);
}

}  // namespace

void create_tables(Database& database) {
  make_missing_tables(database);
  database.exec("PRAGMA application_id = " + std::to_string(application_id));
  database.exec("PRAGMA user_version = " + std::to_string(schema_version));
  fill_dictionary(database);
}

void make_missing_tables(Database& database) { database.exec(tables_sql); }

int version_of(Database& database) { return static_cast<int>(pragma(database, "user_version")); }

bool is_blank(Database& database) {
  try {
    Statement statement(database,
                        "SELECT 1 FROM pragma_application_id, pragma_user_version WHERE "
                        "application_id = 0 AND user_version = 0 AND "
                        "NOT EXISTS (SELECT 1 FROM sqlite_schema)");
    return statement.step();
  } catch (const DatabaseError&) {
    return false;  // no database; whoever looks closer says so
  }
}

bool is_damaged(Database& database, const std::vector<std::string>& tables) {
  Statement check(database, "PRAGMA quick_check(1)");
  if (!check.step() || check.text(0) != "ok") return true;
  return std::any_of(tables.begin(), tables.end(), [&database](const std::string& table) {
    Statement lost(database, "PRAGMA foreign_key_check(" + table + ")");
    return lost.step();
  });
}

void check_database(Database& database) {
  std::int64_t id = 0;
  std::int64_t version = 0;
  try {
    id = pragma(database, "application_id");
    version = pragma(database, "user_version");
  } catch (const DatabaseError& problem) {
    const int code = problem.code() & 0xFF;
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) throw;  // what it is shows later
    refuse_stranger(database.file(), "is not a database; name the .db file of a study");
  }
  if (id != application_id) {
    refuse_stranger(database.file(),
                    "is not a database of Promenade; name the .db file of a study");
  }
  if (version > schema_version) {
    throw InputError(database.file(), "was made by a newer Promenade (its tables are version " +
                                          std::to_string(version) + ", this program knows " +
                                          std::to_string(schema_version) + "); use that one");
  }
}

}  // namespace promenade::study
