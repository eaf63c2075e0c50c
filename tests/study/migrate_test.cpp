#include "study/migrate.h"

#include <sys/stat.h>

#include "folder.h"
#include "old_database.h"
#include "study/schema.h"
#include "study/store.h"
#include "study/store_open.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

using MigrateTest = FolderTest;

std::vector<std::string> schema_of(Database& database) {
  std::vector<std::string> schema;
  for (const std::string& table : tables_of(database)) {
    const std::vector<std::string> columns =
        texts_in(database,
                 "SELECT name || ' ' || type || ' ' || \"notnull\" || ' ' || "
                 "coalesce(dflt_value, '') || ' ' || pk FROM pragma_table_info('" +
                     table + "') ORDER BY name");
    for (const std::string& column : columns) schema.push_back(table + "." + column);
  }
  for (const std::string& index :
       texts_in(database, "SELECT name FROM sqlite_schema WHERE type = 'index' ORDER BY name")) {
    schema.push_back(index);
  }
  return schema;
}

TEST_F(MigrateTest, GivesOldTablesTheColumnsOfNewOnes) {
  make_old_database(file(), 1);
  Database old = open_log(file());
  Database fresh(":memory:", Database::Mode::create);
  create_tables(fresh);
  EXPECT_EQ(schema_of(old), schema_of(fresh));
  EXPECT_EQ(version_of(old), schema_version);
}

// Rows of these are inserted by place.
TEST_F(MigrateTest, GivesThemInTheSameOrder) {
  make_old_database(file(), 1);
  Database old = open_log(file());
  Database fresh(":memory:", Database::Mode::create);
  create_tables(fresh);
  for (const char* table : {"study", "event", "sample", "answer"}) {
    EXPECT_EQ(columns_of(old, table), columns_of(fresh, table)) << table;
  }
}

TEST_F(MigrateTest, KeepsEveryOldRow) {
  make_old_database(file(), 1);
  Database before(file(), Database::Mode::read_only);
  Database after = open_log(file());
  for (const std::string& table : tables_of(before)) {
    if (table == "dictionary") continue;
    const std::vector<std::string> columns = columns_of(before, table);
    const std::string rows = rows_of(before, table, columns);
    EXPECT_FALSE(rows.empty()) << table;
    EXPECT_EQ(rows_of(after, table, columns), rows) << table;
  }
}

TEST_F(MigrateTest, TellsWhatOldRowsLeftUnsaid) {
  make_old_database(file(), 1);
  Database database = open_log(file());
  EXPECT_EQ(number_in(database, "SELECT count(*) FROM study WHERE motion_set IS NULL"), 0);
  EXPECT_EQ(number_in(database,
                      "SELECT count(*) FROM answer WHERE asked IS NOT 'trial' OR "
                      "interface IS NOT (SELECT interface FROM trial WHERE uuid = trial)"),
            0);
  EXPECT_EQ(number_in(database,
                      "SELECT count(*) FROM sample JOIN trial ON trial.uuid = sample.trial "
                      "JOIN event ON event.session = trial.session AND event.seq = after_seq "
                      "WHERE event.t_us <= sample.t_us"),
            number_in(database, "SELECT count(*) FROM sample"));
}

TEST_F(MigrateTest, DescribesEveryColumn) {
  make_old_database(file(), 1);
  Database database = open_log(file());
  EXPECT_EQ(texts_in(database,
                     "SELECT m.name || '.' || p.name FROM sqlite_schema m JOIN "
                     "pragma_table_info(m.name) p WHERE m.type = 'table' EXCEPT "
                     "SELECT table_name || '.' || column_name FROM dictionary"),
            std::vector<std::string>());
}

TEST_F(MigrateTest, ReadsAnOldFileAndLeavesItAlone) {
  make_old_database(file(), 1);
  const std::string before = read_file(file());
  EXPECT_EQ(number_in(file(), "PRAGMA user_version"), 1);
  Database database = open_log(file());
  EXPECT_EQ(database.file(), file());
  EXPECT_EQ(number_in(database, "SELECT count(*) FROM session WHERE resumed = 0"), 2);
  EXPECT_TRUE(read_file(file()) == before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(MigrateTest, CopiesAnOldFileBeforeItIsWritten) {
  make_old_database(file(), 1);
  const Content old = content_of(file());
  { Database database = open_existing_store(file()); }
  EXPECT_EQ(number_in(file(), "PRAGMA user_version"), schema_version);
  const std::string copy = file() + ".v1.backup";
  EXPECT_EQ(content_of(copy), old);
  struct stat status {};
  ASSERT_EQ(::stat(copy.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600U);
  Database database(file(), Database::Mode::read_only);
  EXPECT_EQ(texts_in(database, "SELECT path FROM backup"), std::vector<std::string>{copy});
}

TEST_F(MigrateTest, NeverWritesOverAnotherCopy) {
  make_old_database(file(), 1);
  write_file(file() + ".v1.backup", "dear to somebody");
  { Database database = open_existing_store(file()); }
  EXPECT_EQ(read_file(file() + ".v1.backup"), "dear to somebody");
  EXPECT_EQ(number_in(file() + ".v1.2.backup", "SELECT count(*) FROM session"), 2);
}

TEST_F(MigrateTest, LeavesTheFileOfThisVersionAlone) {
  { Store store(file(), toy::bundle()); }
  { Database database = open_existing_store(file()); }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(MigrateTest, ContinuesAnOldStudyWithTheSameHash) {
  const StudyBundle bundle = toy::bundle();
  make_old_database(file(), 1);
  Database(file(), Database::Mode::read_write)
      .exec("UPDATE study SET study_sha256 = '" + bundle.sha256 + "'");
  Store store(file(), bundle);
  EXPECT_EQ(store.next_simulated_code(), "S003");
  EXPECT_TRUE(fs::exists(file() + ".v1.backup"));
}

TEST_F(MigrateTest, ReadsOldFilesThatHaveTheColumnOfPausesAlready) {
  make_old_database(file(), 1);
  Database(file(), Database::Mode::read_write)
      .exec("ALTER TABLE trial ADD COLUMN paused_us INTEGER; UPDATE trial SET paused_us = 5");
  Database database = open_log(file());
  EXPECT_EQ(number_in(database, "SELECT count(*) FROM trial WHERE paused_us = 5"),
            number_in(database, "SELECT count(*) FROM trial"));
}

// What is wrong, and what is said.
TEST_F(MigrateTest, SaysWhatIsWrongWithAFileThatCannotBeRead) {
  make_old_database(file(), 1);
  const std::string bytes = read_file(file());
  write_file(file("half.db"), bytes.substr(0, bytes.size() / 2));
  write_file(file("text.db"), std::string(200, 'x'));
  make_old_database(file("zero.db"), 1);
  Database(file("zero.db"), Database::Mode::read_write).exec("PRAGMA user_version = 0");
  make_old_database(file("new.db"), 1);
  Database(file("new.db"), Database::Mode::read_write).exec("PRAGMA user_version = 99");
  make_old_database(file("torn.db"), 1);
  Database(file("torn.db"), Database::Mode::read_write).exec("DROP TABLE sample");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"half.db", "is damaged"}, {"text.db", "is not a database"},
      {"zero.db", "is damaged"}, {"new.db", "newer Promenade"},
      {"torn.db", "is damaged"}, {"none.db", "does not exist"},
      {"", "is a folder"}};
  for (const auto& [name, said] : cases) {
    const std::string message = message_of([&] { open_log(file(name)); });
    EXPECT_NE(message.find(said), std::string::npos) << name << ": " << message;
    EXPECT_THROW(open_existing_store(file(name)), InputError) << name;
  }
}

}  // namespace
}  // namespace promenade::study
