// A session is played step by step into a database, and watched from outside meanwhile.
#include "study/watch.h"

#include <fstream>

#include "folder.h"
#include "motion/files.h"
#include "station.h"

namespace promenade::study {
namespace {

using toy::pick;
using toy::Player;
using toy::slide;

// Seconds after the session began.
std::string after(int seconds) {
  return fmt::format("2026-11-22T16:{:02}:{:02}Z", seconds / 60, seconds % 60);
}

class WatchTest : public FolderTest {
 protected:
  void begin(int sequence = 0) {
    store_ = std::make_unique<Store>(file(), bundle_);
    player_ = std::make_unique<Player>(bundle_, sequence);
    SessionHeader header = toy::header("P01", "west");
    store_->begin_session(header, player_->session.plan());
  }
  void at(std::int64_t seconds, decltype(Input::action) action) {
    store_->write(player_->at(1'000'000 * seconds, std::move(action)));
    store_->flush();
  }
  void obey(std::int64_t seconds, const std::string& request, decltype(Input::action) action) {
    store_->write(player_->obey(1'000'000 * seconds, request, std::move(action)));
    store_->flush();
  }
  // Second by second to the first trial whose D is measured; returns when it began.
  int to_trial() {
    int seconds = 0;
    while (!player_->session.trial() || !player_->session.trial()->d) at(++seconds, next());
    return seconds;
  }
  decltype(Input::action) next() const {
    if (player_->session.trial()) return Done{};
    if (player_->session.can_continue()) return Continue{};
    return SetAnswer{"liked", 7};
  }
  const WatchedSession& look(int seconds) {
    const Watched& now = watch_.look(after(seconds));
    if (now.sessions.size() != 1) throw std::logic_error("not one session: " + now.problem);
    return now.sessions[0];
  }
  void execute(const std::string& sql) { store_->database().exec(sql); }

  StudyBundle bundle_ = toy::bundle();
  std::unique_ptr<Store> store_;
  std::unique_ptr<Player> player_;
  Watch watch_{file(), toy::registry()};
};

TEST_F(WatchTest, WaitsForAFileThatIsNotThereYet) {
  EXPECT_NE(watch_.look(after(0)).problem.find("is not there yet"), std::string::npos);
  EXPECT_TRUE(watch_.look(after(0)).waits);
  begin();
  at(1, Continue{});
  EXPECT_EQ(watch_.look(after(1)).problem, "");
  EXPECT_EQ(watch_.look(after(1)).study, bundle_.study.name);
}

TEST_F(WatchTest, WaitsForAFileThatIsBeingMade) {
  std::ofstream(file()).close();
  const Watched& now = watch_.look(after(0));
  EXPECT_NE(now.problem.find("is being made"), std::string::npos) << now.problem;
  EXPECT_FALSE(now.is_input_error);
}

TEST_F(WatchTest, TellsWhoIsWhere) {
  begin();
  at(1, Continue{});
  const WatchedSession& session = look(4);
  EXPECT_EQ(session.participant, "P01");
  EXPECT_EQ(session.station, "west");
  EXPECT_EQ(session.state, WatchedState::running);
  EXPECT_EQ(session.page, to_text(player_->session.page().kind));
  EXPECT_EQ(session.trials, static_cast<int>(player_->session.plan().trials.size()));
  EXPECT_FALSE(session.trial);
  EXPECT_EQ(session.silent_s, 3);
}

TEST_F(WatchTest, TellsTheTrialAsTheSessionHasIt) {
  begin();
  const int began = to_trial();
  at(began + 2, pick("near"));
  at(began + 5, pick("side"));
  const WatchedSession session = look(began + 5);
  const TrialState& real = *player_->session.trial();
  const PlannedTrial& planned =
      player_->session.plan().trials[static_cast<std::size_t>(real.index)];
  ASSERT_TRUE(session.trial);
  EXPECT_EQ(session.trial->position, planned.position);
  EXPECT_EQ(session.trial->task, task_of(bundle_.study, planned).name);
  EXPECT_EQ(session.trial->target, target_of(bundle_.study, planned).name);
  EXPECT_EQ(session.trial->shown.back().d, real.d);
  EXPECT_EQ(session.trial->d_best, real.summary.d_best);
  EXPECT_EQ(session.trial->threshold_m, task_of(bundle_.study, planned).threshold_m);
  EXPECT_DOUBLE_EQ(session.trial->seconds, 5);
  EXPECT_DOUBLE_EQ(*session.trial->left_s(), *session.trial->limit_s - 5);
}

TEST_F(WatchTest, GoesOnWhereItHasReadAndTellsTheSame) {
  begin();
  for (int seconds = 1; player_->session.decided() == Outcome::running; seconds += 2) {
    if (player_->session.trial()) at(seconds, pick("near"));
    at(seconds + 1, next());
    const WatchedSession one = look(seconds + 1);
    Watch fresh(file(), toy::registry());
    const WatchedSession other = fresh.look(after(seconds + 1)).sessions.at(0);
    EXPECT_EQ(one.page, other.page);
    EXPECT_EQ(one.trials_done, other.trials_done);
    ASSERT_EQ(one.trial.has_value(), other.trial.has_value());
    ASSERT_EQ(one.trial.has_value(), player_->session.trial() != nullptr) << "at " << seconds;
    if (!one.trial) continue;
    EXPECT_EQ(one.trial->shown.size(), other.trial->shown.size());
  }
  EXPECT_EQ(look(0).outcome, "finished");
}

TEST_F(WatchTest, StandsStillWhileTheSessionIsPaused) {
  begin();
  const int began = to_trial();
  at(began + 3, Pause{});
  store_->alive(1'000'000 * (began + 10));
  store_->flush();
  EXPECT_EQ(look(began + 10).state, WatchedState::paused);
  EXPECT_DOUBLE_EQ(look(began + 10).trial->seconds, 3);
  at(began + 20, Resume{});
  at(began + 21, pick("near"));
  EXPECT_EQ(look(began + 21).state, WatchedState::running);
  EXPECT_DOUBLE_EQ(look(began + 21).trial->seconds, 4);
  EXPECT_DOUBLE_EQ(look(began + 21).trial->shown.back().seconds, 4);
}

TEST_F(WatchTest, TellsNotesAndLateFrames) {
  begin();
  const int began = to_trial();
  at(began + 1, Note{"歩く \"slowly\""});
  at(began + 2, LateFrame{20'000});
  const WatchedSession session = look(began + 2);
  ASSERT_EQ(session.notes.size(), 1U);
  EXPECT_EQ(session.notes[0].text, "歩く \"slowly\"");
  EXPECT_EQ(session.notes[0].t_us, 1'000'000 * (began + 1));
  EXPECT_EQ(session.trial->late_frames, 1);
}

TEST_F(WatchTest, TellsWhatBecameOfRequests) {
  begin();
  const int began = to_trial();
  obey(began + 1, "a", Pause{});
  obey(began + 2, "b", Refused{"skip", "page"});
  const WatchedSession session = look(began + 2);
  EXPECT_EQ(session.state, WatchedState::paused) << "a refusal ends no pause";
  EXPECT_EQ(session.page_index, player_->session.page_index());
  ASSERT_EQ(session.answers.size(), 2U);
  EXPECT_TRUE(session.answers[0].done && session.answers[0].request == "a");
  EXPECT_FALSE(session.answers[1].done);
  EXPECT_EQ(session.answers[1].request, "b");
  EXPECT_EQ(session.answers[1].why, "page");
  obey(began + 3, "c", Stop{"unwell"});
  store_->end_session(after(began + 3));
  EXPECT_EQ(look(began + 4).answers.size(), 3U) << "the last one, too";
}

TEST_F(WatchTest, SeesThatTheProgramDied) {
  begin();
  const int began = to_trial();
  execute("UPDATE session SET process_start = 'another'");
  store_->flush();
  const WatchedSession& session = look(began + 40);
  EXPECT_EQ(session.state, WatchedState::interrupted);
  EXPECT_EQ(session.silent_s, 40);
  EXPECT_TRUE(session.trial) << "where it stopped";
}

TEST_F(WatchTest, CountsTheTimeBetweenTwoProgramsOnce) {
  begin();
  const int began = to_trial();
  at(began + 1, Interrupted{100'000'000, ResumePolicy::continue_});
  at(began + 2, Resume{});
  EXPECT_EQ(look(began + 2 + 100).silent_s, 0);
  EXPECT_EQ(look(began + 2 + 107).silent_s, 7);
}

TEST_F(WatchTest, TellsAboutHowLongItWillStillTake) {
  begin();
  at(1, Continue{});
  const auto at_first = look(1).minutes_left;
  to_trial();
  const auto later = look(20).minutes_left;
  ASSERT_TRUE(at_first && later);
  EXPECT_GT(*later, 0);
  EXPECT_LT(*later, *at_first);
}

TEST_F(WatchTest, ListsWhatEndedForHalfADay) {
  toy::make_station(file(), {"P01", "P02"});  // both end at 17:00
  const Watched& now = watch_.look("2026-11-23T04:59:00Z");
  EXPECT_EQ(now.finished, 2);
  ASSERT_EQ(now.sessions.size(), 2U);
  EXPECT_EQ(now.sessions[0].state, WatchedState::ended);
  EXPECT_EQ(now.sessions[0].outcome, "finished");
  EXPECT_EQ(now.sessions[0].ended_s, 11 * 3600 + 59 * 60);
  EXPECT_EQ(now.sessions[0].trials_done,
            static_cast<int>(make_plan(bundle_.study, 0).trials.size()));
  EXPECT_EQ(watch_.look("2026-11-23T05:01:00Z").sessions.size(), 0U);
  EXPECT_EQ(now.finished, 2);
}

TEST_F(WatchTest, LeavesTheFileAndItsFolderAsTheyWere) {
  toy::make_station(file(), {"P01"});
  const std::string before = read_file(file());
  watch_.look(after(0));
  watch_.look(after(1));
  EXPECT_EQ(read_file(file()), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(WatchTest, HoldsUpNoCheckpoint) {
  begin();
  to_trial();
  watch_.look(after(1));
  Statement checkpoint(store_->database(), "PRAGMA wal_checkpoint(TRUNCATE)");
  ASSERT_TRUE(checkpoint.step());
  EXPECT_EQ(checkpoint.integer(0), 0) << "it was not held up";
  EXPECT_EQ(std::filesystem::file_size(file() + "-wal"), 0U);
}

TEST_F(WatchTest, ForgetsAFileThatWentAwayOrWasReplaced) {
  toy::make_station(file(), {"P01"});
  EXPECT_EQ(watch_.look(after(0)).finished, 1);
  toy::make_station(file("other.db"), {"P01", "P02"});
  std::filesystem::rename(file("other.db"), file());
  EXPECT_EQ(watch_.look(after(1)).finished, 2);
  std::filesystem::remove(file());
  EXPECT_EQ(watch_.look(after(2)).finished, 0);
  EXPECT_NE(watch_.look(after(2)).problem, "");
}

TEST_F(WatchTest, SaysThatAnotherProgramHoldsTheFile) {
  toy::make_station(file(), {"P01"});
  std::optional<Database> holder(std::in_place, file(), Database::Mode::read_write);
  holder->exec("PRAGMA locking_mode = EXCLUSIVE; UPDATE session SET station = 'east'");
  const Watched& now = watch_.look(after(0));
  EXPECT_TRUE(now.is_locked) << now.problem;
  EXPECT_NE(now.problem, "");
  holder.reset();
  EXPECT_EQ(watch_.look(after(1)).problem, "");
}

TEST_F(WatchTest, SaysWhatIsWrongWithTheFile) {
  std::ofstream(file()) << "no database at all, but text that is long enough to be looked at\n";
  EXPECT_NE(watch_.look(after(0)).problem.find("is not a database"), std::string::npos);
  EXPECT_TRUE(watch_.look(after(0)).is_input_error);
  std::filesystem::remove(file());
  begin();
  EXPECT_FALSE(watch_.look(after(0)).is_locked);
  execute("PRAGMA user_version = 99");
  store_->flush();
  EXPECT_NE(watch_.look(after(0)).problem.find("newer Promenade"), std::string::npos);
  execute("PRAGMA user_version = 2");
  EXPECT_EQ(watch_.look(after(1)).problem, "") << "and goes on when it can";
}

}  // namespace
}  // namespace promenade::study
