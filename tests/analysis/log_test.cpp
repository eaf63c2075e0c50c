#include "analysis/log.h"

#include <gtest/gtest.h>

#include <limits>

#include "motion/files.h"
#include "motion/problem.h"
#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

std::string message_of(const std::vector<std::string>& files) {
  try {
    read_log(files);
  } catch (const InputError& error) {
    return error.what();
  }
  return "read without a word";
}

bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

TEST(Log, HoldsSessionsTrialsAndAnswersButNoPractice) {
  const TestFolder folder;
  ToyLog(folder.file("a.db"))
      .session({"P01"})
      .trial({.practice = true})
      .trial({"labels", "happy", 12.5, 0.034})
      .answer("ease", 5)
      .answer("ease", 6, false);
  const Log log = read_log({folder.file("a.db")});
  ASSERT_EQ(log.trials.size(), 1u);
  EXPECT_EQ(log.sessions[0].code, "P01");
  EXPECT_EQ(log.trials[0].ended_us, 12'500'000);
  EXPECT_EQ(log.trials[0].d_final, 0.034);
  ASSERT_EQ(log.answers.size(), 1u) << "an untouched answer is none";
  EXPECT_EQ(log.answers[0].value, 5);
}

TEST(Log, LeavesOutWhatWasDoneAgainAndWhatHasNoInterface) {
  const TestFolder folder;
  ToyLog log(folder.file("a.db"));
  log.session({"P01"}).trial({"labels", "happy"}).trial({"labels", "happy", 8}).trial({"", "sad"});
  log.database().exec("UPDATE trial SET superseded = 1 WHERE position = 1");
  const Log read = read_log({folder.file("a.db")});
  ASSERT_EQ(read.trials.size(), 1u);
  EXPECT_EQ(read.trials[0].ended_us, 8'000'000);
}

TEST(Log, JoinsFilesOfOneStudyAndTakesEachSessionOnce) {
  const TestFolder folder;
  { fill(*std::make_unique<ToyLog>(folder.file("a.db")), 2, 0, "a"); }
  { fill(*std::make_unique<ToyLog>(folder.file("b.db")), 3, 0, "b"); }
  const Log log = read_log({folder.file("a.db"), folder.file("b.db"), folder.file("a.db")});
  EXPECT_EQ(log.sessions.size(), 5u);
  EXPECT_EQ(log.trials.size(), 10u);
  EXPECT_EQ(log.repeated_sessions, 2);
  EXPECT_EQ(log.files[2].trials, 0);
}

TEST(Log, RefusesFilesOfDifferentStudies) {
  const TestFolder folder;
  { ToyLog a(folder.file("a.db"), "abc"); }
  { ToyLog b(folder.file("b.db"), "def"); }
  EXPECT_TRUE(says(message_of({folder.file("a.db"), folder.file("b.db")}), "another study"));
}

// Makes "def" the version after "abc" in a database of it.
void amend(ToyLog& log) {
  log.database().exec(
      "INSERT INTO study SELECT 'study-def', name, '2', config_text, 'def', program_version, "
      "created_utc, motion_set FROM study WHERE uuid = 'study-abc'");
  log.database().exec(
      "INSERT INTO amendment(study, previous, reason, amended_utc) VALUES "
      "('study-def', 'study-abc', 'too long', '2026-11-23T09:00:00Z')");
}

TEST(Log, CountsTheRowsOfEachVersionOfTheStudy) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({"P01"}).trial({}).session({"P02", "stopped"});
    amend(log);
    log.database().exec("UPDATE session SET study = 'study-def' WHERE outcome = 'stopped'");
  }
  const Log log = read_log({folder.file("a.db")});
  EXPECT_EQ(log.sha256, "def");
  ASSERT_EQ(log.versions.size(), 2u);
  EXPECT_EQ(log.versions[0].sessions, 1);
  EXPECT_EQ(log.versions[0].finished, 1);
  EXPECT_EQ(log.versions[0].trials, 1);
  EXPECT_EQ(log.versions[1].reason, "too long");
  EXPECT_EQ(log.versions[1].sessions, 1);
  EXPECT_EQ(log.versions[1].finished, 0);
}

TEST(Log, JoinsFilesWhoseNewestVersionIsTheSame) {
  const TestFolder folder;
  for (const char* name : {"a.db", "b.db"}) {
    ToyLog log(folder.file(name));
    amend(log);
  }
  { ToyLog new_station(folder.file("c.db"), "def"); }
  { ToyLog behind(folder.file("d.db")); }
  const Log log = read_log({folder.file("c.db"), folder.file("a.db"), folder.file("b.db")});
  ASSERT_EQ(log.versions.size(), 2u);
  EXPECT_EQ(log.versions[1].sha256, "def");
  EXPECT_EQ(log.versions[1].reason, "too long");
  EXPECT_TRUE(says(message_of({folder.file("a.db"), folder.file("d.db")}), "another version"));
}

TEST(Log, NamesEveryFileThatIsNoDatabase) {
  const TestFolder folder;
  write_file(folder.file("text.db"), "this is a text and certainly not a database at all");
  write_file(folder.file("empty.db"), "");
  const std::string message = message_of({folder.file("text.db"), folder.file("empty.db"),
                                          folder.file("missing.db"), folder.file("")});
  EXPECT_TRUE(says(message, "text.db: error: is not a database"));
  EXPECT_TRUE(says(message, "empty.db: error: is not a database"));
  EXPECT_TRUE(says(message, "missing.db: error: does not exist"));
  EXPECT_TRUE(says(message, "is a folder"));
}

TEST(Log, RefusesTheDatabaseOfAnotherProgram) {
  const TestFolder folder;
  {
    study::Database other(folder.file("other.db"), study::Database::Mode::create);
    other.exec("CREATE TABLE bookmarks(url TEXT)");
  }
  EXPECT_TRUE(says(message_of({folder.file("other.db")}), "not a database of Promenade"));
}

TEST(Log, RefusesTheDatabaseOfANewerVersion) {
  const TestFolder folder;
  { ToyLog(folder.file("new.db")).database().exec("PRAGMA user_version = 99"); }
  EXPECT_TRUE(says(message_of({folder.file("new.db")}), "newer Promenade"));
}

TEST(Log, RefusesADatabaseCutOffAnywhere) {
  const TestFolder folder;
  { fill(*std::make_unique<ToyLog>(folder.file("a.db")), 40, 0.001); }
  const std::string bytes = read_file(folder.file("a.db"));
  for (const std::size_t kept : {bytes.size() / 2, bytes.size() - 4096, std::size_t{4096},
                                 std::size_t{5000}, std::size_t{100}}) {
    write_file(folder.file("cut.db"), bytes.substr(0, kept));
    EXPECT_NE(message_of({folder.file("cut.db")}), "read without a word") << kept;
  }
}

TEST(Log, RefusesTablesThatAreNotThere) {
  const TestFolder folder;
  { ToyLog(folder.file("a.db")).database().exec("DROP TABLE answer"); }
  EXPECT_TRUE(says(message_of({folder.file("a.db")}), "damaged"));
}

TEST(Log, RefusesRowsThatReferToNothing) {
  for (const char* table : {"participant", "session", "trial"}) {
    const TestFolder folder;
    {
      ToyLog log(folder.file("a.db"));
      log.session({}).trial({}).answer("ease", 3);
      log.database().exec("PRAGMA foreign_keys = OFF");
      log.database().exec(std::string("DELETE FROM ") + table);
    }
    EXPECT_TRUE(says(message_of({folder.file("a.db")}), "a.db: error: is damaged")) << table;
  }
}

TEST(Log, ReadsDatabasesOfBeforeThereWerePauses) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.session({}).trial({});
    log.database().exec("ALTER TABLE trial DROP COLUMN paused_us; PRAGMA user_version = 1");
  }
  const Log log = read_log({folder.file("a.db")});
  ASSERT_EQ(log.trials.size(), 1U);
  EXPECT_EQ(log.trials[0].paused_us, 0);
}

TEST(Log, TakesInfiniteValuesForMissingAndCountsThem) {
  const TestFolder folder;
  const double infinity = std::numeric_limits<double>::infinity();
  ToyLog(folder.file("a.db")).session({}).trial({.d_final = infinity}).answer("ease", infinity);
  const Log log = read_log({folder.file("a.db")});
  EXPECT_EQ(log.trials[0].d_final, std::nullopt);
  EXPECT_TRUE(log.answers.empty());
  EXPECT_EQ(log.not_finite, 3) << "d_best, d_final and the answer";
}

TEST(Log, LeavesTheFileAndItsFolderAsTheyWere) {
  const TestFolder folder;
  {
    ToyLog log(folder.file("a.db"));
    log.database().exec("PRAGMA journal_mode = WAL");
    fill(log, 2, 0);
  }
  const std::string before = read_file(folder.file("a.db"));
  read_log({folder.file("a.db")});
  EXPECT_EQ(read_file(folder.file("a.db")), before);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.db-wal")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.db-shm")));
}

TEST(Log, ReadsWhatARunningSessionHasNotYetCheckpointed) {
  const TestFolder folder;
  ToyLog running(folder.file("a.db"));
  running.database().exec("PRAGMA journal_mode = WAL");
  fill(running, 2, 0);
  EXPECT_EQ(read_log({folder.file("a.db")}).trials.size(), 4u);
}

}  // namespace
}  // namespace promenade::analysis
