#include "study/copy.h"

#include <algorithm>
#include <filesystem>

#include "study/database_file.h"
#include "study/identity.h"
#include "study/schema.h"
#include "study/study.h"

namespace promenade::study {
namespace {

std::int64_t count_of(Database& database, const std::string& table) {
  Statement count(database, "SELECT count(*) FROM " + table);
  count.step();
  return count.integer(0);
}

void verify(Database& original, const std::string& path) {
  Database copy(path, Database::Mode::read_only);
  bool same = !is_damaged(copy, {});
  for (const char* table : {"session", "trial"}) {
    same = same && count_of(copy, table) == count_of(original, table);
  }
  if (same) return;
  throw OutsideError("the copy " + path + " is not what was written; check the disk that it is on");
}

// Is the file at `path` a copy of another database than this one? A file that cannot be read
// is no copy of anything.
bool is_copy_of_another(Database& database, const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return false;
  try {
    Database copy(path, Database::Mode::read_only);
    check_database(copy);
    Statement theirs(copy, "SELECT uuid FROM study");
    Statement known(database, "SELECT 1 FROM study WHERE uuid = ?");
    bool any = false;
    while (theirs.step()) {
      known.reset();
      any = true;
      if (known.bind(1, theirs.text(0)).step()) return false;
    }
    return any;
  } catch (const std::exception&) {
    return false;
  }
}

void renew(const std::string& file, const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  if (!std::filesystem::is_directory(folder)) {
    throw OutsideError("there is no folder " + folder + "; connect its disk or make it");
  }
  Database database(file, Database::Mode::read_write);
  if (is_copy_of_another(database, path)) {
    throw OutsideError(path +
                       " is the copy of another database; give each station a name of its "
                       "own (--station) or move that copy away");
  }
  copy_database(file, path);
  note_backup(database, path);
}

}  // namespace

void copy_database(const std::string& file, const std::string& path) {
  Database database(file, Database::Mode::read_write);
  database.exec("BEGIN; SELECT count(*) FROM study");  // from here on it is seen as it is now
  const std::string part = path + ".part";
  remove_database(part);
  make_private_file(part);
  try {
    {
      Database copy(part, Database::Mode::read_write);
      copy.exec("PRAGMA synchronous = OFF");  // it is brought to the disk at once, below
      backup(database, copy);
    }
    verify(database, part);
    rename_durably(part, path);
  } catch (const std::exception&) {
    remove_database(part);
    throw;
  }
}

void note_backup(Database& database, const std::string& path) {
  Statement note(database, "INSERT OR REPLACE INTO backup(path, made_utc) VALUES (?,?)");
  note.bind(1, std::filesystem::absolute(path).lexically_normal().string());
  note.bind(2, utc_now()).run();
}

std::string second_copy_path(const StudyBundle& bundle, const std::string& file,
                             const std::string& station) {
  const std::string& folder = bundle.study.safety.copy_to;
  if (folder.empty()) return "";
  std::string place = station;
  std::replace(place.begin(), place.end(), '/', '_');
  const std::filesystem::path home = std::filesystem::path(bundle.file).parent_path();
  const std::string name = std::filesystem::path(file).stem().string() + "-" + place + ".db";
  return (home / folder / name).string();
}

std::optional<std::string> second_copy_problem(const StudyBundle& bundle, const std::string& file,
                                               const std::string& station) {
  const std::string path = second_copy_path(bundle, file, station);
  if (path.empty()) return std::nullopt;
  try {
    renew(file, path);
    return std::nullopt;
  } catch (const std::exception& error) {
    return std::string("no second copy of the session: ") + error.what();
  }
}

}  // namespace promenade::study
