#include "study/withdraw.h"

#include "folder.h"
#include "motion/files.h"
#include "old_database.h"
#include "station.h"
#include "study/copy.h"
#include "study/migrate.h"
#include "study/schema.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

using WithdrawTest = FolderTest;

const std::string keeping = toy::study_text() + "[safety]\nwithdraw = \"link\"\n";
constexpr const char* code = "Zwetschge-17";

std::string uuid_of(const std::string& file, const std::string& participant) {
  Database database(file, Database::Mode::read_only);
  return texts_in(database, "SELECT uuid FROM participant WHERE code = '" + participant + "'")[0];
}

// How often the word stands in the bytes of the file or its journal.
int times_in(const std::string& file, const std::string& word) {
  int times = 0;
  for (const char* ending : {"", "-wal"}) {
    if (!fs::exists(file + ending)) continue;
    const std::string bytes = read_file(file + ending);
    for (std::size_t at = 0; (at = bytes.find(word, at)) != std::string::npos; ++at) ++times;
  }
  return times;
}

void back_up(const std::string& file, const std::string& path) {
  copy_database(file, path);
  Database database(file, Database::Mode::read_write);
  note_backup(database, path);
}

TEST_F(WithdrawTest, RemovesEveryRowOfThePersonAndNoOther) {
  toy::make_station(file(), {"P01", code, "P02"});
  const std::int64_t events = number_in(file(), "SELECT count(*) FROM event");
  const Withdrawn withdrawn = withdraw(file(), code);
  EXPECT_EQ(withdrawn.removed.at("session"), 1);
  EXPECT_EQ(withdrawn.removed.at("trial"), 6);
  EXPECT_EQ(withdrawn.removed.at("event"), events / 3);
  EXPECT_EQ(number_in(file(), "SELECT count(*) FROM event"), events - events / 3);
  EXPECT_EQ(number_in(file(), "SELECT count(*) FROM participant"), 2);
  for (const char* table : {"session", "trial", "event", "sample", "answer"}) {
    EXPECT_EQ(number_in(file(), std::string("SELECT count(*) FROM pragma_foreign_key_check('") +
                                    table + "')"),
              0);
  }
}

TEST_F(WithdrawTest, LeavesNoByteOfTheCodeAndTheUuidInTheTombstoneOnly) {
  toy::make_station(file(), {"P01", code, "P02"});
  const std::string uuid = uuid_of(file(), code);
  ASSERT_GT(times_in(file(), code), 0);
  ASSERT_GT(times_in(file(), uuid), 1);
  withdraw(file(), code);
  EXPECT_EQ(times_in(file(), code), 0);
  EXPECT_EQ(times_in(file(), uuid), 1);
  Database database(file(), Database::Mode::read_only);
  EXPECT_EQ(texts_in(database, "SELECT participant || removed FROM tombstone"),
            std::vector<std::string>{uuid + "everything"});
}

// As programs did that deleted without secure_delete.
TEST_F(WithdrawTest, ClearsWhatWasLeftInFreePages) {
  toy::make_station(file(), {"P01", code});
  Database(file(), Database::Mode::read_write)
      .exec(std::string("PRAGMA secure_delete = OFF; CREATE TABLE old(code); INSERT INTO old "
                        "VALUES('") +
            code + "'); DROP TABLE old");
  ASSERT_GT(times_in(file(), code), 2) << "the row and its index";
  withdraw(file(), code);
  EXPECT_EQ(times_in(file(), code), 0);
}

TEST_F(WithdrawTest, EmptiesTheJournalOfAnotherConnection) {
  toy::make_station(file(), {"P01"});
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  toy::log_session(store, bundle, toy::header(code), 1);
  withdraw(file(), code);
  EXPECT_EQ(times_in(file(), code), 0);
}

TEST_F(WithdrawTest, KeepsAnswersAndTrialsWhereTheConsentSaysSo) {
  toy::make_station(file(), {code, "P02"}, 0, keeping);
  const std::string uuid = uuid_of(file(), code);
  const auto answers = number_in(file(),
                                 "SELECT count(*) FROM answer JOIN trial ON trial.uuid = "
                                 "answer.trial AND trial.session = answer.session");
  const Withdrawn withdrawn = withdraw(file(), code);
  EXPECT_EQ(withdrawn.unlinked, 1);
  EXPECT_EQ(number_in(file(),
                      "SELECT count(*) FROM answer JOIN trial ON trial.uuid = "
                      "answer.trial AND trial.session = answer.session JOIN session ON "
                      "session.uuid = trial.session JOIN participant ON "
                      "participant.uuid = session.participant"),
            answers);
  EXPECT_EQ(number_in(file(),
                      "SELECT count(*) FROM session WHERE outcome = 'withdrawn' AND "
                      "started_utc = '0001-01-01T00:00:00Z' AND ended_utc = started_utc "
                      "AND station = '' AND machine = '{}' AND process_start IS NULL"),
            1);
  EXPECT_EQ(number_in(file(), "SELECT count(*) FROM pragma_foreign_key_check"), 0);
  EXPECT_EQ(times_in(file(), code), 0);
  EXPECT_EQ(times_in(file(), uuid), 1) << "the tombstone";
}

TEST_F(WithdrawTest, GivesKeptSessionsAndTrialsNamesThatNoExportKnows) {
  toy::make_station(file(), {code}, 0, keeping);
  Database before(file(), Database::Mode::read_only);
  const auto names = texts_in(before, "SELECT uuid FROM session UNION SELECT uuid FROM trial");
  withdraw(file(), code);
  for (const std::string& name : names) EXPECT_EQ(times_in(file(), name), 0);
}

TEST_F(WithdrawTest, TakesThePersonOffTheRoster) {
  toy::make_station(file(), {code, "P02"});
  Database(file(), Database::Mode::read_write)
      .exec(std::string("INSERT INTO roster VALUES('") + code +
            "','1',0,'done',NULL,'2026'),('P02','1',1,'done','" + code + "','2026')");
  withdraw(file(), code);
  EXPECT_EQ(number_in(file(), "SELECT count(*) FROM roster WHERE replaces IS NULL"), 1);
  EXPECT_EQ(times_in(file(), code), 0);
}

TEST_F(WithdrawTest, ReachesTheBackups) {
  toy::make_station(file(), {"P01", code}, 0, keeping);
  back_up(file(), file("copy.db"));
  const Withdrawn withdrawn = withdraw(file(), code);
  ASSERT_EQ(withdrawn.backups.size(), 1U);
  EXPECT_EQ(withdrawn.backups[0].problem, "");
  EXPECT_EQ(times_in(file("copy.db"), code), 0);
  EXPECT_EQ(number_in(file("copy.db"), "SELECT count(*) FROM session"), 1);
  EXPECT_EQ(number_in(file("copy.db"), "SELECT count(*) FROM tombstone"), 1);
  EXPECT_FALSE(fs::exists(file("copy.db-wal")));
}

TEST_F(WithdrawTest, ReachesTheCopyOfBeforeAMigration) {
  make_old_database(file(), 1);
  ASSERT_GT(times_in(file(), "S001"), 0);
  const Withdrawn withdrawn = withdraw(file(), "S001");
  ASSERT_EQ(withdrawn.backups.size(), 1U);
  EXPECT_EQ(withdrawn.backups[0].problem, "");
  EXPECT_EQ(times_in(file(), "S001"), 0);
  EXPECT_EQ(times_in(file() + ".v1.backup", "S001"), 0);
  EXPECT_EQ(number_in(file() + ".v1.backup", "SELECT count(*) FROM session"), 1);
}

TEST_F(WithdrawTest, RemembersBackupsOutOfReachUntilTheyAreBack) {
  toy::make_station(file(), {"P01", code});
  back_up(file(), file("stick.db"));
  fs::rename(file("stick.db"), file("elsewhere.db"));
  const Withdrawn withdrawn = withdraw(file(), code);
  ASSERT_EQ(withdrawn.backups.size(), 1U);
  EXPECT_NE(withdrawn.backups[0].problem.find("not there"), std::string::npos);
  EXPECT_FALSE(finish_withdrawals(file()).backups[0].problem.empty());
  fs::rename(file("elsewhere.db"), file("stick.db"));
  EXPECT_EQ(finish_withdrawals(file()).backups[0].problem, "");
  EXPECT_EQ(times_in(file("stick.db"), code), 0);
  EXPECT_TRUE(finish_withdrawals(file()).backups.empty());
}

TEST_F(WithdrawTest, ForgetsABackupThatIsGone) {
  toy::make_station(file(), {"P01", code});
  back_up(file(), file("stick.db"));
  fs::remove(file("stick.db"));
  withdraw(file(), code);
  EXPECT_NE(message_of([&] { forget_backup(file(), file("stik.db")); }).find("did you mean"),
            std::string::npos);
  forget_backup(file(), file("stick.db"));
  EXPECT_TRUE(finish_withdrawals(file()).backups.empty());
}

TEST_F(WithdrawTest, WritesNothingForACodeThatNobodyHas) {
  make_old_database(file(), 1);
  const std::string before = read_file(file());
  const std::string said = message_of([&] { withdraw(file(), "S01"); });
  EXPECT_NE(said.find("nobody in it has the code \"S01\""), std::string::npos) << said;
  EXPECT_NE(said.find("did you mean"), std::string::npos) << said;
  EXPECT_TRUE(read_file(file()) == before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(WithdrawTest, WaitsForTheEndOfASession) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  store.begin_session(toy::header(code), make_plan(bundle.study, 0));
  EXPECT_THROW(withdraw(file(), code), OutsideError);
  EXPECT_EQ(number_in(file(), "SELECT count(*) FROM session"), 1);
  store.write({SessionEnded{5, Outcome::stopped}});
  store.end_session("2026-11-22T17:00:00Z");
  withdraw(file(), code);
  EXPECT_EQ(number_in(file(), "SELECT count(*) FROM session"), 0);
}

TEST_F(WithdrawTest, WaitsForThePersonToLeaveTheLastPage) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  store.begin_session(toy::header(code), make_plan(bundle.study, 0));
  store.write({SessionDecided{5, Outcome::declined}});
  EXPECT_THROW(withdraw(file(), code), OutsideError);
}

TEST_F(WithdrawTest, NamesWhatIsNoDatabase) {
  toy::make_station(file(), {"P01"});
  const std::string bytes = read_file(file());
  write_file(file("half.db"), bytes.substr(0, bytes.size() / 2));
  write_file(file("text.db"), std::string(200, 'x'));
  toy::make_station(file("new.db"), {"P01"});
  Database(file("new.db"), Database::Mode::read_write).exec("PRAGMA user_version = 99");
  for (const char* name : {"half.db", "text.db", "new.db", "none.db", ""}) {
    EXPECT_THROW(withdraw(file(name), "P01"), InputError) << name;
    EXPECT_THROW(finish_withdrawals(file(name)), InputError) << name;
  }
}

}  // namespace
}  // namespace promenade::study
