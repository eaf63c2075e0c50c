#include "study/migrate.h"

#include <array>
#include <filesystem>

#include "study/copy.h"
#include "study/database_file.h"
#include "study/schema.h"

namespace promenade::study {
namespace {

struct Column {
  const char* table;
  const char* name;
  const char* declaration;
};

// What version 2 has beside version 1, in the order of a new database. `paused_us` is in
// some files of version 1 already.
constexpr auto columns_of_2 = std::to_array<Column>({
    {"study", "motion_set", "TEXT REFERENCES motion_set(uuid)"},
    {"session", "process_start", "TEXT"},
    {"session", "resumed", "INTEGER NOT NULL DEFAULT 0"},
    {"session", "alive_us", "INTEGER"},
    {"trial", "paused_us", "INTEGER"},
    {"trial", "attempt", "INTEGER NOT NULL DEFAULT 1"},
    {"trial", "superseded", "INTEGER NOT NULL DEFAULT 0 CHECK (superseded IN (0,1))"},
    {"trial", "d_area_m_s", "REAL"},
    {"trial", "path_m", "REAL"},
    {"trial", "reversals", "INTEGER"},
    {"trial", "drags", "INTEGER"},
    {"trial", "controls_touched", "INTEGER"},
    {"trial", "examples_visited", "INTEGER"},
    {"trial", "map_coverage", "REAL"},
    {"trial", "idle_us", "INTEGER"},
    {"trial", "camera_moves", "INTEGER"},
    {"sample", "after_seq", "INTEGER"},
    {"answer", "asked", "TEXT"},
    {"answer", "about", "TEXT REFERENCES trial(uuid)"},
    {"answer", "block", "INTEGER"},
    {"answer", "task", "TEXT"},
    {"answer", "interface", "TEXT"},
    {"answer", "place", "INTEGER"},
});

// The motions were of the only study, answers of a trial, and a sample came right behind the
// last event before it, which an index finds in less than a scan of all.
constexpr const char* rows_of_2 = R"sql(
UPDATE study SET motion_set = (SELECT uuid FROM motion_set LIMIT 1);
UPDATE trial SET paused_us = 0 WHERE paused_us IS NULL AND ended_us IS NOT NULL;
UPDATE answer SET asked = 'trial', about = trial, (block, task, interface) =
  (SELECT block, task, interface FROM trial WHERE uuid = answer.trial) WHERE trial IS NOT NULL;
CREATE INDEX event_by_time ON event(session, t_us, seq);
UPDATE sample SET after_seq =
  (SELECT seq FROM event WHERE session = (SELECT session FROM trial WHERE uuid = sample.trial)
   AND t_us <= sample.t_us ORDER BY t_us DESC, seq DESC LIMIT 1);
DROP INDEX event_by_time;
)sql";

bool has_column(Database& database, const Column& column) {
  Statement known(database, "SELECT 1 FROM pragma_table_info(?) WHERE name = ?");
  return known.bind(1, column.table).bind(2, column.name).step();
}

void migrate_1_to_2(Database& database) {
  for (const Column& column : columns_of_2) {
    if (has_column(database, column)) continue;
    database.exec(std::string("ALTER TABLE ") + column.table + " ADD COLUMN " + column.name + " " +
                  column.declaration);
  }
  make_missing_tables(database);
  database.exec(rows_of_2);
}

using Step = void (*)(Database&);
constexpr std::array<Step, schema_version - 1> steps = {migrate_1_to_2};

// FILE.v1.backup, FILE.v1.2.backup, ...
std::string unused_name(const std::string& stem) {
  std::error_code ignored;
  std::string name = stem + ".backup";
  for (int i = 2; std::filesystem::exists(name, ignored); ++i) {
    name = stem + "." + std::to_string(i) + ".backup";
  }
  return name;
}

Database migrated_in_memory(Database& old) {
  Database database(old.file(), Database::Mode::memory);
  backup(old, database);
  Transaction transaction(database);
  migrate_tables(database);
  transaction.commit();
  return database;
}

}  // namespace

void migrate_tables(Database& database) {
  const int version = version_of(database);
  if (version < 1) throw InputError(database.file(), damaged_database);
  for (std::size_t i = static_cast<std::size_t>(version - 1); i < steps.size(); ++i) {
    steps[i](database);
  }
  database.exec("PRAGMA user_version = " + std::to_string(schema_version));
  fill_dictionary(database);
}

void migrate_file(Database& database) {
  if (version_of(database) == schema_version) return;
  Transaction transaction(database);
  const int version = version_of(database);
  if (version == schema_version) return;  // another process was faster
  const std::string copy = unused_name(database.file() + ".v" + std::to_string(version));
  copy_database(database.file(), copy);
  try {
    migrate_tables(database);
    note_backup(database, copy);
    transaction.commit();
  } catch (const std::exception&) {
    remove_database(copy);
    throw;
  }
}

Database open_log(const std::string& file, int wait_ms) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw InputError(file, "does not exist");
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(file, "is a folder; name the .db file of a study");
  }
  Database database(file, Database::Mode::read_only, wait_ms);
  check_database(database);
  try {
    return version_of(database) == schema_version ? std::move(database)
                                                  : migrated_in_memory(database);
  } catch (const DatabaseError& problem) {
    if (!problem.about_content()) throw;
    throw InputError(file, damaged_database);
  }
}

}  // namespace promenade::study
