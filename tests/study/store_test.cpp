#include "study/store.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <future>

#include "play.h"
#include "study/identity.h"
#include "study/schema.h"
#include "study/sqlite.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

// A folder that goes away with its test.
class StoreTest : public testing::Test {
 protected:
  StoreTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~StoreTest() override { fs::remove_all(folder_); }
  std::string file(const std::string& name = "toy.db") const { return (folder_ / name).string(); }

  std::int64_t count(const std::string& sql) const {
    Database database(file(), Database::Mode::read_only);
    Statement statement(database, sql);
    return statement.step() ? statement.integer(0) : -1;
  }

  fs::path folder_ =
      fs::temp_directory_path() / ("promenade_store_" + std::to_string(::getpid()) + "_" +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

void log_session(Store& store, const StudyBundle& bundle, const SessionHeader& header,
                 int sequence) {
  toy::Player player(bundle, sequence);
  player.whole_session();
  store.begin_session(header, player.session.plan());
  store.write(player.records);
  store.end_session("2026-11-22T17:00:00Z");
}

SessionHeader header(const std::string& code) {
  SessionHeader header;
  header.participant = code;
  header.started_utc = "2026-11-22T16:00:00Z";
  return header;
}

std::string refusal(const std::string& file, const StudyBundle& bundle) {
  try {
    Store store(file, bundle);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(StoreTest, KeepsEveryRecordOfASession) {
  const StudyBundle bundle = toy::bundle();
  toy::Player player(bundle);
  player.whole_session();
  Store store(file(), bundle);
  log_session(store, bundle, header("P01"), 0);
  EXPECT_EQ(count("SELECT count(*) FROM event"),
            static_cast<std::int64_t>(player.all<Event>().size()));
  EXPECT_EQ(count("SELECT count(*) FROM sample"),
            static_cast<std::int64_t>(player.all<Sample>().size()));
  EXPECT_EQ(count("SELECT count(*) FROM trial WHERE outcome IS NOT NULL AND ended_us > 0"), 6);
  EXPECT_EQ(count("SELECT count(*) FROM answer WHERE value = 7 AND trial IS NOT NULL"), 4);
  EXPECT_EQ(count("SELECT count(*) FROM session WHERE outcome = 'finished' AND process IS NULL"),
            1);
}

TEST_F(StoreTest, KeepsTheVeryNumbers) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  log_session(store, bundle, header("P01"), 0);
  toy::Player player(bundle);
  player.whole_session();
  Database database(file(), Database::Mode::read_only);
  Statement rows(database, "SELECT t_us, d, weights FROM sample ORDER BY t_us, rowid");
  for (const Sample& sample : player.all<Sample>()) {
    ASSERT_TRUE(rows.step());
    EXPECT_EQ(rows.integer(0), sample.t_us);
    EXPECT_EQ(rows.is_null(1), !sample.d);
    EXPECT_EQ(rows.real(1), sample.d.value_or(0));
    ASSERT_EQ(rows.blob(2).size(), 3 * sizeof(double));
    EXPECT_EQ(std::memcmp(rows.blob(2).data(), sample.weights.data(), 24), 0);
  }
}

TEST_F(StoreTest, KeepsHowLongATrialStood) {
  const StudyBundle bundle = toy::bundle();
  toy::Player player(bundle);
  player.to_trial(0);
  player.at(1'000'000, Pause{});
  player.at(8'500'000, Resume{});
  player.at(9'000'000, Done{});
  Store store(file(), bundle);
  store.begin_session(header("P01"), player.session.plan());
  store.write(player.records);
  store.flush();
  EXPECT_EQ(count("SELECT paused_us FROM trial"), 7'500'000);
  EXPECT_EQ(count("SELECT count(*) FROM event WHERE kind IN ('pause', 'resume') AND "
                  "actor = 'participant' AND trial IS NOT NULL"),
            2);
}

TEST_F(StoreTest, HoldsTheMotionsThatWereShown) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  Database database(file(), Database::Mode::read_only);
  Statement set(database, "SELECT content, sha256 FROM motion_set");
  ASSERT_TRUE(set.step());
  EXPECT_EQ(set.blob(0), bundle.set_bytes);
  EXPECT_EQ(set.text(1), sha256_hex(bundle.set_bytes));
}

TEST_F(StoreTest, IsForItsOwnerOnly) {
  Store store(file(), toy::bundle());
  struct stat status {};
  for (const char* end : {"", "-wal"}) {
    ASSERT_EQ(::stat((file() + end).c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0600U) << end;
  }
}

TEST_F(StoreTest, FillsTheLowestFreeOrderOfTheSameKind) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  log_session(store, bundle, header("P01"), 0);
  log_session(store, bundle, header("P02"), 2);
  SessionHeader pilot = header("P03");
  pilot.pilot = true;
  log_session(store, bundle, pilot, 1);
  EXPECT_EQ(store.next_sequence(false, false), 1);
  EXPECT_EQ(store.next_sequence(false, true), 0);
  EXPECT_EQ(store.next_sequence(true, false), 0);
}

TEST_F(StoreTest, GivesTheOrderOfADeclinedSessionAgain) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  store.begin_session(header("P01"), make_plan(bundle.study, 0));
  EXPECT_EQ(store.next_sequence(false, false), 1);
  store.write({SessionEnded{5, Outcome::declined}});
  store.end_session("2026-11-22T17:00:00Z");
  EXPECT_EQ(store.next_sequence(false, false), 0);
}

TEST_F(StoreTest, KeepsTheNumberOfAKilledSessionForItsResume) {
  const StudyBundle bundle = toy::bundle();
  const pid_t child = ::fork();
  if (child == 0) {
    Store store(file(), bundle);
    store.begin_session(header("P01"), make_plan(bundle.study, 0));
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  Store store(file(), bundle);
  EXPECT_EQ(count("SELECT count(*) FROM session WHERE outcome = 'running'"), 1);
  // Its order is missing all the same: 2 has it too.
  EXPECT_EQ(store.next_sequences(false, false, 2), (std::vector<int>{1, 2}));
}

// Its first page, then as many as there are until the last one.
void read_to_the_end(toy::Player& player) {
  for (std::int64_t t = 1'000'000; player.session.decided() == Outcome::running; t += 1'000'000) {
    if (player.session.trial()) {
      player.at(t, Done{});
    } else if (player.session.can_continue()) {
      player.at(t, Continue{});
    } else {
      player.at(t, SetAnswer{"liked", 7});
    }
  }
}

TEST_F(StoreTest, KnowsTheOutcomeWhileTheLastPageIsOpen) {
  const StudyBundle bundle = toy::bundle();
  const pid_t child = ::fork();
  if (child == 0) {
    Store store(file(), bundle);
    toy::Player player(bundle);
    read_to_the_end(player);
    store.begin_session(header("P01"), player.session.plan());
    store.write(player.records);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  Store store(file(), bundle);
  EXPECT_EQ(count("SELECT count(*) FROM session WHERE outcome = 'finished' AND ended_utc > ''"), 1);
  EXPECT_TRUE(store.interrupted_sessions(false, false).empty());
  EXPECT_EQ(store.next_sequences(false, false, 2), (std::vector<int>{1, 2}));
}

TEST_F(StoreTest, OpensASessionAgainWhoseLastTrialIsRepeatedFromTheLastPage) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  toy::Player player(bundle);
  read_to_the_end(player);
  store.begin_session(header("P01"), player.session.plan());
  store.write(player.records);
  store.write(player.at(100'000'000, Repeat{false, "why"}));
  EXPECT_EQ(count("SELECT count(*) FROM session WHERE outcome = 'running' AND ended_utc IS NULL"),
            1);
  store.write(player.at(101'000'000, Stop{"why"}));
  EXPECT_EQ(count("SELECT count(*) FROM session WHERE outcome = 'stopped'"), 1);
}

TEST_F(StoreTest, FillsTheOrderThatIsMissingMost) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  for (const int sequence : {0, 2, 3, 4}) {
    log_session(store, bundle, header("P0" + std::to_string(sequence)), sequence);
  }
  EXPECT_EQ(store.next_sequences(false, false, 3), (std::vector<int>{1, 5, 6}));
}

TEST_F(StoreTest, GivesTheOrderOfAWithdrawnPersonAgain) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  log_session(store, bundle, header("P01"), 0);
  Database(file(), Database::Mode::read_write)
      .exec("INSERT INTO tombstone SELECT uuid, '2026-11-22T18:00:00Z', 'link' FROM participant");
  EXPECT_EQ(store.next_sequence(false, false), 1);  // the data stay
  Database(file(), Database::Mode::read_write).exec("UPDATE tombstone SET removed = 'everything'");
  EXPECT_EQ(store.next_sequence(false, false), 0);
}

// What another process would be.
TEST_F(StoreTest, RefusesAnOrderThatAnotherSessionTookMeanwhile) {
  const StudyBundle bundle = toy::bundle();
  Store one(file(), bundle);
  Store other(file(), bundle);
  one.begin_session(header("P01"), make_plan(bundle.study, 0));
  EXPECT_THROW(other.begin_session(header("P02"), make_plan(bundle.study, 0)), TakenError);
  EXPECT_FALSE(one.knows_participant("P02"));
  other.begin_session(header("P02"), make_plan(bundle.study, other.next_sequence(false, false)));
  EXPECT_EQ(count("SELECT count(DISTINCT sequence) FROM session"), 2);
}

TEST_F(StoreTest, RefusesTheCodeOfANewParticipantThatIsUsed) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  store.begin_session(header("P01"), make_plan(bundle.study, 0));
  SessionHeader same = header("P01");
  store.begin_session(same, make_plan(bundle.study, 1));
  same.new_participant = true;
  EXPECT_THROW(store.begin_session(same, make_plan(bundle.study, 2)), TakenError);
  EXPECT_EQ(count("SELECT count(*) FROM session"), 2);
}

TEST_F(StoreTest, CountsSimulatedCodes) {
  const StudyBundle bundle = toy::bundle();
  Store store(file(), bundle);
  EXPECT_EQ(store.next_simulated_code(), "S001");
  log_session(store, bundle, header("S001"), 0);
  EXPECT_EQ(store.next_simulated_code(), "S002");
  EXPECT_TRUE(store.knows_participant("S001"));
  EXPECT_FALSE(store.knows_participant("S002"));
}

TEST_F(StoreTest, TakesTheSameStudyAgain) {
  const StudyBundle bundle = toy::bundle();
  { Store store(file(), bundle); }
  { Store store(file(), bundle); }
  EXPECT_EQ(count("SELECT count(*) FROM study"), 1);
}

TEST_F(StoreTest, TakesAFileWhoseMakingWasCutOff) {
  { Database(file(), Database::Mode::create).exec("PRAGMA journal_mode = WAL"); }
  ASSERT_GT(fs::file_size(file()), 0U);
  { Store store(file(), toy::bundle()); }
  EXPECT_EQ(count("SELECT count(*) FROM study"), 1);
}

TEST_F(StoreTest, IsMadeOnceWhenTwoOpenItAtOnce) {
  const StudyBundle bundle = toy::bundle();
  for (int round = 0; round < 20; ++round) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    const auto open = [&] { return refusal(file(), bundle); };
    auto other = std::async(std::launch::async, open);
    EXPECT_EQ(open(), "");
    EXPECT_EQ(other.get(), "");
  }
  EXPECT_EQ(count("SELECT count(*) FROM study"), 1);
}

TEST_F(StoreTest, RefusesAnotherStudy) {
  { Store store(file(), toy::bundle()); }
  std::string text = toy::study_text();
  text.replace(text.find("\"toy\""), 5, "\"other\"");
  EXPECT_EQ(refusal(file(), toy::bundle(text)),
            file() + ": error: holds another study, \"toy\"; name another database for \"other\"");
}

TEST_F(StoreTest, RefusesAChangedStudy) {
  { Store store(file(), toy::bundle()); }
  const std::string said = refusal(file(), toy::bundle(toy::study_text() + "# changed\n"));
  EXPECT_NE(said.find("as it was before"), std::string::npos) << said;
}

TEST_F(StoreTest, RefusesForeignFilesAndLeavesThemAlone) {
  std::ofstream(file()) << "This is a letter, not a database, and longer than a header.\n";
  EXPECT_EQ(refusal(file(), toy::bundle()),
            file() + ": error: is not a database; name the .db file of a study");
  EXPECT_EQ(fs::file_size(file()), 60U);
  { Database(file("x.db"), Database::Mode::create).exec("CREATE TABLE study(name)"); }
  EXPECT_NE(refusal(file("x.db"), toy::bundle()).find("is not a database of Promenade"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(file("x.db-wal")));
}

TEST_F(StoreTest, RefusesNewerDatabases) {
  { Store store(file(), toy::bundle()); }
  Database(file(), Database::Mode::read_write).exec("PRAGMA user_version = 99");
  EXPECT_NE(refusal(file(), toy::bundle()).find("newer Promenade"), std::string::npos);
}

TEST_F(StoreTest, SaysWhereItCannotWrite) {
  EXPECT_THROW(Store("/proc/none/toy.db", toy::bundle()), OutsideError);
  EXPECT_THROW(Store(folder_, toy::bundle()), InputError);
}

// What someone does in step `t` of a session: eight changes, then Done.
void work(toy::Player& player, std::int64_t t) {
  if (!player.session.trial()) {
    player.at(t * 1000, SetAnswer{"liked", 4});
    player.at(t * 1000, Continue{});
  } else if (t % 9 == 0) {
    player.at(t * 1000, Done{});
  } else {
    player.at(t * 1000, toy::slide("side", 0.1 * static_cast<double>(t % 9)));
  }
}

// The child logs a session like a window does, commits each step but the last, and
// kills itself without any tidying up.
void die_after(const std::string& file, const StudyBundle& bundle, int steps) {
  Store store(file, bundle);
  toy::Player player(bundle, 1);
  store.begin_session(header("P01"), player.session.plan());
  for (std::int64_t t = 1; t <= steps; ++t) {
    const std::size_t before = player.records.size();
    work(player, t);
    store.write(
        {player.records.begin() + static_cast<std::ptrdiff_t>(before), player.records.end()});
    if (t < steps) store.flush();
  }
  ::kill(::getpid(), SIGKILL);
}

// Samples of finished trials must be as many as were logged, the last one the final D.
void expect_whole_trials(const std::string& file, const toy::Player& same) {
  Database database(file, Database::Mode::read_write);
  Statement check(database, "PRAGMA integrity_check");
  ASSERT_TRUE(check.step());
  EXPECT_EQ(check.text(0), "ok");
  Statement rows(database,
                 "SELECT d_final, (SELECT count(*) FROM sample WHERE trial = t.uuid), "
                 "(SELECT d FROM sample WHERE trial = t.uuid ORDER BY t_us DESC) "
                 "FROM trial t WHERE outcome IS NOT NULL ORDER BY position");
  const std::vector<Sample> samples = same.all<Sample>();
  for (const TrialEnded& ended : same.all<TrialEnded>()) {
    ASSERT_TRUE(rows.step());
    EXPECT_EQ(rows.integer(1), std::count_if(samples.begin(), samples.end(), [&](const auto& s) {
                return s.trial == ended.trial;
              }));
    EXPECT_EQ(rows.real(0), ended.d_final.value_or(0));
    EXPECT_EQ(rows.real(2), ended.d_final.value_or(0));
  }
  EXPECT_FALSE(rows.step());
}

TEST_F(StoreTest, KeepsEveryFinishedTrialWholeWhenItIsKilled) {
  const StudyBundle bundle = toy::bundle();
  for (const int steps : {4, 9, 14, 18, 27, 40}) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    const pid_t child = ::fork();
    if (child == 0) die_after(file(), bundle, steps);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    toy::Player same(bundle, 1);
    for (std::int64_t t = 1; t <= steps; ++t) work(same, t);
    expect_whole_trials(file(), same);
  }
}

}  // namespace
}  // namespace promenade::study
