#include "study/sqlite.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

template <typename Work>
std::string failure(const Work& work) {
  try {
    work();
  } catch (const DatabaseError& error) {
    return error.what();
  }
  return "";
}

class SqliteTest : public testing::Test {
 protected:
  ~SqliteTest() override { fs::remove(file_); }

  std::string file_ =
      (fs::temp_directory_path() / ("promenade_sqlite_" + std::to_string(::getpid()) + ".db"))
          .string();
};

TEST_F(SqliteTest, SaysWhatToDoWhenTheDiskIsFull) {
  Database database(":memory:", Database::Mode::create);
  database.exec("CREATE TABLE t(x); PRAGMA max_page_count = 2");
  const std::string said =
      failure([&] { database.exec("INSERT INTO t VALUES (randomblob(100000))"); });
  EXPECT_EQ(said.find(":memory:: the disk is full; make room"), 0U) << said;
}

TEST_F(SqliteTest, SaysWhatToDoWhenAnotherProgramWrites) {
  Database one(file_, Database::Mode::create);
  Database other(file_, Database::Mode::create);
  sqlite3_busy_timeout(other.handle(), 0);
  one.exec("BEGIN IMMEDIATE");
  const std::string said = failure([&] { other.exec("BEGIN IMMEDIATE"); });
  EXPECT_NE(said.find("another program is writing"), std::string::npos) << said;
}

TEST_F(SqliteTest, SaysWhatToDoWhenItMustNotWrite) {
  { Database(file_, Database::Mode::create).exec("CREATE TABLE t(x)"); }
  Database database(file_, Database::Mode::read_only);
  const std::string said = failure([&] { database.exec("INSERT INTO t VALUES (1)"); });
  EXPECT_NE(said.find("allow writing"), std::string::npos) << said;
}

// As a killed session leaves it, where SQLite cannot make its -shm: on a disk that must not be
// written, or here because a link to nowhere stands in its place.
TEST_F(SqliteTest, SaysWhatToDoWhenTheWalCannotBeRead) {
  Database writer(file_, Database::Mode::create);
  writer.exec("PRAGMA journal_mode = WAL; CREATE TABLE t(x)");
  const std::string killed = file_ + ".killed";
  for (const char* end : {"", "-wal"}) fs::copy_file(file_ + end, killed + end);
  fs::create_symlink(file_ + ".nowhere", killed + "-shm");
  const std::string said = failure([&] { Database(killed, Database::Mode::read_only); });
  EXPECT_NE(said.find("-wal, which can only be read where files may be made; copy both"), said.npos)
      << said;
  fs::remove(killed + "-shm");
  Database reader(killed, Database::Mode::read_only);
  EXPECT_EQ(failure([&] { Statement(reader, "SELECT x FROM t").step(); }), "");
  for (const char* end : {"", "-wal", "-shm"}) fs::remove(killed + end);
}

TEST_F(SqliteTest, SaysWhatToDoWhenItIsNoDatabase) {
  std::ofstream(file_) << std::string(5000, 'x');
  Database database(file_, Database::Mode::read_write);
  const std::string said = failure([&] { database.exec("CREATE TABLE t(x)"); });
  EXPECT_NE(said.find("damaged or no database"), std::string::npos) << said;
}

TEST_F(SqliteTest, KeepsTheWordsOfSqliteForTheRest) {
  Database database(":memory:", Database::Mode::create);
  const std::string said = failure([&] { database.exec("SELEC 1"); });
  EXPECT_EQ(said, ":memory:: near \"SELEC\": syntax error");
}

}  // namespace
}  // namespace promenade::study
