#include "study/store_open.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "study/schema.h"
#include "study/store.h"

namespace promenade::study {
namespace {

void make_folder(const std::filesystem::path& file) {
  if (!file.has_parent_path()) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (!error) return;
  throw OutsideError("cannot make the folder " + file.parent_path().string() + " (" +
                     error.message() + "); name another place for the database");
}

// The file is there with rights for its owner only before SQLite opens it; its
// journal gets the same rights.
void make_private_file(const std::string& file) {
  const int handle = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (handle < 0) {
    throw OutsideError("cannot write " + file + " (" + std::strerror(errno) +
                       "); name another place for the database");
  }
  ::close(handle);
}

bool has_tables(Database& database) {
  Statement statement(database, "SELECT 1 FROM sqlite_schema WHERE name = 'study'");
  return statement.step();
}

void refuse_other_study(Database& database, const StudyBundle& bundle) {
  Statement known(database, "SELECT 1 FROM study WHERE study_sha256 = ?");
  if (known.bind(1, bundle.sha256).step()) return;
  Statement other(database, "SELECT name FROM study ORDER BY rowid DESC LIMIT 1");
  if (!other.step()) return;  // killed while it was made
  const std::string name = other.text(0);
  throw InputError(database.file(),
                   name == bundle.study.name
                       ? "holds the study \"" + name +
                             "\" as it was before its file, its motions or the texts of the "
                             "program changed; name a new database for the changed study"
                       : "holds another study, \"" + name + "\"; name another database for \"" +
                             bundle.study.name + "\"");
}

void put_study(Database& database, const StudyBundle& bundle) {
  Statement study(database, "INSERT OR IGNORE INTO study VALUES (?,?,?,?,?,?,?)");
  study.bind(1, random_uuid()).bind(2, bundle.study.name).bind(3, bundle.study.version);
  study.bind(4, bundle.config_text).bind(5, bundle.sha256).bind(6, program_version());
  study.bind(7, utc_now()).run();
  Statement set(database, "INSERT OR IGNORE INTO motion_set VALUES (?,?,?,?)");
  set.bind(1, random_uuid()).bind(2, bundle.space.set.name).bind(3, bundle.set_sha256);
  set.bind_blob(4, bundle.set_bytes).run();
}

// Reads only: a file that is not ours stays as it is.
void check_existing(const std::string& file, const StudyBundle& bundle) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return;
  if (std::filesystem::is_directory(file, error)) {
    throw InputError(file, "is a folder; name the .db file of a study");
  }
  if (std::filesystem::file_size(file, error) == 0) return;
  Database database(file, Database::Mode::read_only);
  check_database(database);
  if (has_tables(database)) refuse_other_study(database, bundle);
}

}  // namespace

Database open_store(const std::filesystem::path& path, const StudyBundle& bundle) {
  const std::string file = path.string();
  if (file != ":memory:") {
    check_existing(file, bundle);
    make_folder(path);
    make_private_file(file);
  }
  Database database(file, Database::Mode::read_write);
  database.exec("PRAGMA journal_mode = WAL");
  database.exec("PRAGMA wal_autocheckpoint = 0");
  database.exec("PRAGMA synchronous = NORMAL");
  database.exec("PRAGMA foreign_keys = ON");
  if (!has_tables(database)) create_tables(database);
  put_study(database, bundle);
  return database;
}

}  // namespace promenade::study
