// A session that was interrupted goes on in the same file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "play.h"
#include "study/process.h"
#include "study/replay.h"
#include "study/simulate.h"
#include "study/sqlite.h"
#include "study/store.h"
#include "toy.h"

namespace promenade::study {
namespace {

namespace fs = std::filesystem;

class Resume : public testing::Test {
 protected:
  Resume() { fs::create_directories(folder_); }
  ~Resume() override { fs::remove_all(folder_); }
  std::string file() const { return (folder_ / "toy.db").string(); }

  static SessionHeader header(const std::string& code, bool simulated = false) {
    SessionHeader header;
    header.participant = code;
    header.simulated = simulated;
    header.started_utc = "2026-11-22T16:00:00Z";
    return header;
  }

  // Two trials, the second of which runs; then nobody is there any more.
  void die_in_second_trial(bool simulated = false) const {
    Store store(file(), bundle_);
    toy::Player player(bundle_);
    player.to_trial(1'000'000);
    player.at(2'000'000, toy::pick("side"));
    player.at(3'000'000, Done{});
    player.to_trial(4'000'000);
    player.at(5'000'000, toy::pick("side"));
    store.begin_session(header("P01", simulated), player.session.plan());
    store.write(player.records);
    store.flush();
    forget_process();
  }

  void forget_process() const {
    Database database(file(), Database::Mode::read_write);
    database.exec("UPDATE session SET process_start = 'another boot:1'");
  }

  std::int64_t count(const std::string& sql) const {
    Database database(file(), Database::Mode::read_only);
    Statement statement(database, sql);
    return statement.step() ? statement.integer(0) : -1;
  }

  StudyBundle bundle_ = toy::bundle();
  fs::path folder_ =
      fs::temp_directory_path() / ("promenade_resume_" + std::to_string(::getpid()) + "_" +
                                   testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Resume, IsOfferedForWhatNoProcessRuns) {
  die_in_second_trial();
  Store store(file(), bundle_);
  const std::vector<InterruptedSession> found = store.interrupted_sessions(false, false);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].participant, "P01");
  EXPECT_EQ(found[0].trial, 2);
  EXPECT_EQ(found[0].last_us, 5'000'000);
  EXPECT_TRUE(store.interrupted_sessions(false, true).empty()) << "a pilot is of another kind";
}

TEST_F(Resume, IsNotOfferedWhileTheProcessLives) {
  Store store(file(), bundle_);
  toy::Player player(bundle_);
  store.begin_session(header("P01"), player.session.plan());
  EXPECT_TRUE(store.interrupted_sessions(false, false).empty());
}

TEST_F(Resume, HappensOnce) {
  die_in_second_trial();
  Store store(file(), bundle_);
  const LoggedSession log = store.read_session(store.interrupted_sessions(false, false)[0].uuid);
  const Plan plan = make_plan(bundle_.study, log.sequence);
  store.resume_session(log, plan);
  EXPECT_EQ(count("SELECT resumed FROM session"), 1);
  EXPECT_TRUE(store.interrupted_sessions(false, false).empty());
  EXPECT_THROW(store.resume_session(log, plan), TakenError);
}

TEST_F(Resume, GoesOnWithTheRowsOfTheFile) {
  die_in_second_trial();
  {
    Store store(file(), bundle_);
    const LoggedSession log = store.read_session(store.interrupted_sessions(false, false)[0].uuid);
    Session session = replay(bundle_, toy::registry(), log);
    store.resume_session(log, session.plan());
    Input input;
    input.t_us = log.last_us;
    input.action = Interrupted{0, ResumePolicy::redo_trial};
    store.write(session.step(input));
    store.flush();
  }
  EXPECT_EQ(count("SELECT count(*) FROM trial WHERE position = 2 AND superseded = 1 AND outcome = "
                  "'aborted'"),
            1);
  EXPECT_EQ(count("SELECT count(*) = max(seq) FROM event"), 1) << "no number twice, none left out";
}

TEST_F(Resume, OfASimulatedSessionPlaysItToItsEnd) {
  die_in_second_trial(true);
  Store store(file(), bundle_);
  EXPECT_EQ(resume_simulated_sessions(bundle_, toy::registry(), store, 1), 1);
  EXPECT_EQ(count("SELECT count(*) FROM session WHERE outcome = 'finished' AND resumed = 1"), 1);
  EXPECT_EQ(count("SELECT count(*) FROM trial WHERE outcome IS NOT NULL"), 6);
  Audit result;
  Database database(file(), Database::Mode::read_only);
  audit(bundle_, toy::registry(), read_session(database, session_uuids(database)[0]), result);
  EXPECT_TRUE(result.differences.empty()) << result.differences[0].what;
}

TEST_F(Resume, BeginsAsOthersDoWhereNothingWasStored) {
  {
    Store store(file(), bundle_);
    toy::Player player(bundle_);
    store.begin_session(header("S001", true), player.session.plan());
    forget_process();
  }
  Store store(file(), bundle_);
  EXPECT_EQ(resume_simulated_sessions(bundle_, toy::registry(), store, 1), 1);
  EXPECT_EQ(count("SELECT kind = 'page' FROM event ORDER BY seq LIMIT 1"), 1);
  Audit result;
  Database database(file(), Database::Mode::read_only);
  audit(bundle_, toy::registry(), read_session(database, session_uuids(database)[0]), result);
  EXPECT_TRUE(result.differences.empty()) << result.differences[0].what;
}

TEST(GapOfASession, LeavesOutTheGapsBeforeAndIsNeverNegative) {
  LoggedSession session;
  session.started_utc = "2026-11-22T16:00:00Z";
  session.last_us = 60'000'000;
  EXPECT_EQ(gap_us(session, "2026-11-22T16:02:00Z"), 60'000'000);
  LoggedStep interrupted;
  interrupted.event.kind = "interrupted";
  interrupted.event.value = 45;
  session.steps.push_back(interrupted);
  EXPECT_EQ(gap_us(session, "2026-11-22T16:02:00Z"), 15'000'000);
  EXPECT_EQ(gap_us(session, "2025-11-22T16:02:00Z"), 0) << "the clock was set back";
  EXPECT_EQ(gap_us(session, "yesterday"), 0);
}

TEST(Process, IsKnownByItsNumberAndItsStart) {
  const std::string start = process_start(::getpid());
  EXPECT_FALSE(start.empty());
  EXPECT_TRUE(lives(::getpid(), start));
  EXPECT_TRUE(lives(::getpid(), "")) << "an old database does not say the start";
  EXPECT_FALSE(lives(::getpid(), start + "1")) << "another process had this number";
  EXPECT_FALSE(lives(0, ""));
  EXPECT_TRUE(process_start(-1).empty());
}

}  // namespace
}  // namespace promenade::study
