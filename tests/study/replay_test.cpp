#include "study/replay.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "play.h"
#include "study/simulate.h"
#include "study/sqlite.h"
#include "study/store.h"
#include "study/stored_study.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

class ReplayTest : public testing::Test {
 protected:
  ReplayTest() { fs::create_directories(folder_); }
  ~ReplayTest() override { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "toy.db").string(); }

  void simulate(int participants) const {
    Store store(file(), bundle_);
    Cohort cohort;
    cohort.participants = participants;
    simulate_cohort(bundle_, toy::registry(), store, cohort);
  }

  Audit audit_all() const {
    Database database(file(), Database::Mode::read_only);
    Audit result;
    for (const std::string& uuid : session_uuids(database)) {
      audit(bundle_, toy::registry(), read_session(database, uuid), result);
    }
    return result;
  }

  StudyBundle bundle_ = toy::bundle();
  fs::path folder_ =
      fs::temp_directory_path() / ("promenade_replay_" + std::to_string(::getpid()) + "_" +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(ReplayTest, ReproducesEveryWeightAndD) {
  simulate(4);
  const Audit audit = audit_all();
  EXPECT_EQ(audit.sessions, 4);
  EXPECT_EQ(audit.trials, 24);
  EXPECT_GT(audit.numbers, 300);
  EXPECT_TRUE(audit.differences.empty()) << audit.differences[0].what;
}

TEST_F(ReplayTest, FindsANumberThatWasChangedByABillionth) {
  simulate(2);
  Database database(file(), Database::Mode::read_write);
  database.exec(
      "UPDATE sample SET d = d * (1 + 3e-9) WHERE rowid = (SELECT max(rowid) FROM sample "
      "WHERE d > 0.01)");
  const Audit audit = audit_all();
  ASSERT_EQ(audit.differences.size(), 1U);
  EXPECT_EQ(audit.differences[0].what, "d");
}

TEST_F(ReplayTest, FindsAnEventThatIsGoneAndASummaryThatIsWrong) {
  simulate(2);
  Database database(file(), Database::Mode::read_write);
  database.exec(
      "UPDATE trial SET clicks = clicks + 1 WHERE position = 2 AND session = (SELECT "
      "uuid FROM session WHERE sequence = 0)");
  EXPECT_EQ(audit_all().differences.at(0).what, "clicks");
  database.exec(
      "DELETE FROM event WHERE kind = 'done' AND seq = (SELECT min(seq) FROM event "
      "WHERE kind = 'done')");
  EXPECT_GT(audit_all().differences.size(), 1U);
}

TEST_F(ReplayTest, LeadsBackToTheVeryStateOfAnInterruptedSession) {
  toy::Player player(bundle_);
  Store store(file(), bundle_);
  SessionHeader header;
  header.participant = "P1";
  store.begin_session(header, player.session.plan());
  player.to_trial(0);
  player.at(1000, toy::pick("side"));
  player.at(2000, toy::slide("far", 0.25));
  store.write(player.records);
  store.flush();
  Database database(file(), Database::Mode::read_only);
  const LoggedSession log = read_session(database, session_uuids(database).at(0));
  const Session again = replay(bundle_, toy::registry(), log);
  ASSERT_NE(again.trial(), nullptr);
  EXPECT_EQ(again.trial()->index, player.session.trial()->index);
  EXPECT_EQ(again.trial()->weights, player.session.trial()->weights);
  EXPECT_EQ(again.trial()->d, player.session.trial()->d);
  EXPECT_EQ(log.last_us, 2000);
}

TEST_F(ReplayTest, ReproducesWhatAWatcherAskedFor) {
  toy::Player player(bundle_);
  player.to_trial(0);
  player.obey(1000, "a", Pause{});
  player.obey(2000, "b", Refused{"pause", "state"});
  player.obey(3000, "c", Resume{});
  player.obey(4000, "d", Note{"a \"note\""});
  player.obey(5000, "e", Repeat{false, "the phone rang"});
  player.to_trial(6000);
  player.obey(7000, "f", Skip{"again"});
  Store store(file(), bundle_);
  SessionHeader header;
  header.participant = "P1";
  store.begin_session(header, player.session.plan());
  store.write(player.records);
  store.flush();
  EXPECT_TRUE(audit_all().differences.empty());
  Database database(file(), Database::Mode::read_only);
  std::vector<Event> again;
  replay(bundle_, toy::registry(), read_session(database, session_uuids(database).at(0)),
         [&again](const Session&, const std::vector<Record>& records) {
           for (const Record& record : records) {
             if (const auto* event = std::get_if<Event>(&record)) again.push_back(*event);
           }
         });
  const std::vector<Event> played = player.all<Event>();
  ASSERT_EQ(again.size(), played.size());
  for (std::size_t i = 0; i < played.size(); ++i) EXPECT_EQ(again[i].detail, played[i].detail);
}

TEST_F(ReplayTest, NeedsNothingBesideTheDatabase) {
  simulate(1);
  Database database(file(), Database::Mode::read_only);
  const LoggedSession log = read_session(database, session_uuids(database).at(0));
  const StudyBundle stored = read_stored_study(database, log.study_uuid, toy::registry());
  EXPECT_EQ(study_hash(stored, toy::registry()), bundle_.sha256);
  Audit result;
  audit(stored, toy::registry(), log, result);
  EXPECT_TRUE(result.differences.empty());
}

}  // namespace
}  // namespace promenade::study
