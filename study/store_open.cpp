#include "study/store_open.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "motion/files.h"
#include "study/database_file.h"
#include "study/identity.h"
#include "study/migrate.h"
#include "study/schema.h"
#include "study/store.h"
#include "study/versions.h"

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

// One at a time makes a database in a folder: SQLite does not wait for another that
// switches the same new file to its journal mode. Where folders cannot be locked, or
// somebody keeps this one, it goes on without.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& file)
      : handle_(::open((file.has_parent_path() ? file.parent_path() : ".").c_str(),
                       O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    constexpr auto pause = std::chrono::milliseconds(5);
    for (int tries = 0; tries < 400; ++tries) {  // two seconds, as long as SQLite waits
      if (::flock(handle_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
      std::this_thread::sleep_for(pause);
    }
  }
  ~FolderLock() {
    if (handle_ >= 0) ::close(handle_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int handle_;
};

bool has_tables(Database& database) {
  Statement statement(database, "SELECT 1 FROM sqlite_schema WHERE name = 'study'");
  return statement.step();
}

void refuse_other_study(Database& database, const StudyBundle& bundle) {
  const std::string problem = study_problem(database, bundle);
  if (!problem.empty()) throw InputError(database.file(), problem);
}

// The uuid of the motion set of a study, which several versions may share.
std::string put_motion_set(Database& database, const StudyBundle& bundle) {
  Statement insert(database, "INSERT OR IGNORE INTO motion_set VALUES (?,?,?,?)");
  insert.bind(1, random_uuid()).bind(2, bundle.space.set.name).bind(3, bundle.set_sha256);
  insert.bind_blob(4, bundle.set_bytes).run();
  Statement known(database, "SELECT uuid FROM motion_set WHERE sha256 = ?");
  known.bind(1, bundle.set_sha256).step();
  return known.text(0);
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
  if (is_blank(database)) return;
  check_database(database);
  if (has_tables(database)) refuse_other_study(database, bundle);
}

// As one: another process may be making the same file, and either may be killed.
void make_tables(Database& database, const StudyBundle& bundle) {
  Transaction transaction(database);
  if (!has_tables(database)) create_tables(database);
  refuse_other_study(database, bundle);
  put_study(database, bundle);
  transaction.commit();
}

Database open_to_write(const std::string& file) {
  Database database(file, Database::Mode::read_write);
  database.exec("PRAGMA journal_mode = WAL");
  database.exec("PRAGMA wal_autocheckpoint = 0");
  database.exec("PRAGMA synchronous = NORMAL");
  database.exec("PRAGMA foreign_keys = ON");
  database.exec("PRAGMA secure_delete = ON");
  if (has_tables(database)) migrate_file(database);
  return database;
}

Database prepared(const std::string& file, const StudyBundle& bundle) {
  Database database = open_to_write(file);
  make_tables(database, bundle);
  return database;
}

}  // namespace

std::string put_study(Database& database, const StudyBundle& bundle) {
  Statement known(database, "SELECT uuid FROM study WHERE study_sha256 = ?");
  if (known.bind(1, bundle.sha256).step()) return known.text(0);
  std::string uuid = random_uuid();
  Statement study(database, "INSERT INTO study VALUES (?,?,?,?,?,?,?,?)");
  study.bind(1, uuid).bind(2, bundle.study.name).bind(3, bundle.study.version);
  study.bind(4, bundle.config_text).bind(5, bundle.sha256).bind(6, program_version());
  study.bind(7, utc_now()).bind(8, put_motion_set(database, bundle)).run();
  Statement part(database, "INSERT INTO study_part VALUES (?,?,?)");
  for (const StudyPart& one : bundle.parts) {
    part.bind(1, uuid).bind(2, one.path).bind_blob(3, one.content).run();
  }
  return uuid;
}

Database open_store(const std::filesystem::path& path, const StudyBundle& bundle) {
  const std::string file = path.string();
  if (file == ":memory:") return prepared(file, bundle);
  make_folder(path);
  const FolderLock lock(path);
  check_existing(file, bundle);
  const bool made = make_private_file(file);
  try {
    return prepared(file, bundle);
  } catch (const OutsideError&) {
    if (made) remove_database(file);
    throw;
  }
}

Database open_existing_store(const std::string& file) {
  open_log(file);  // says what is wrong with it
  const FolderLock lock(file);
  require_writable(file);
  return open_to_write(file);
}

void remove_unused_store(const std::filesystem::path& path) {
  try {
    Database database(path.string(), Database::Mode::read_only);
    Statement session(database, "SELECT 1 FROM session");
    if (session.step()) return;
  } catch (const DatabaseError&) {
    return;  // it is not known what is in it
  }
  remove_database(path.string());
}

}  // namespace promenade::study
