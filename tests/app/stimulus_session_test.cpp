// A stimulus on its page: it plays from its start by the time of the session, and a replay of the
// log shows the same.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "app/trial_player.h"
#include "motion/files.h"
#include "motion/graph/graph_file.h"
#include "study/migrate.h"
#include "study/stimulus.h"
#include "study/stored_study.h"
#include "tests/app/session_bench.h"
#include "tests/app/walks_graph.h"
#include "tests/test_folder.h"

namespace promenade::app {
namespace {

using bench::SessionBench;

class StimulusPage : public testing::Test {
 protected:
  std::string text() const {
    write_file(folder_.file("walks.graph"), motion::to_bytes(bench::walks_graph()));
    return "[study]\nname = 'stimuli'\norder = 'fixed'\n"
           "[[stimulus]]\nname = 'happy_then_sad'\ngraph = '" +
           folder_.file("walks.graph") +
           "'\nparts = [{label = 'happy', seconds = 3}, {label = 'sad', seconds = 3}]\n"
           "[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = 'impression'\nplayback = true\n"
           "targets = [{stimulus = 'happy_then_sad'}]\n";
  }
  // Its page is open, and was shown once.
  bool open() {
    const bool shown = bench_.play(5, [&] { return bench_.session().trial() != nullptr; });
    walk(1);
    return shown;
  }
  void walk(int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      shown_us_ = bench_.session_us();
      bench_.walk();
    }
  }
  const study::Stimulus& stimulus() { return *bench_.session().trial()->stimulus; }
  double seconds_shown() { return bench_.view().stage().phase() * stimulus().seconds(); }
  // Since the trial began.
  double trial_seconds() {
    return 1e-6 * static_cast<double>(shown_us_ - bench_.session().trial()->started_us);
  }

  TestFolder folder_;
  SessionBench bench_{"en", 1, text()};
  std::int64_t shown_us_ = 0;
};

TEST_F(StimulusPage, BeginsAtItsStartAndGoesOnInTheTimeOfTheSession) {
  ASSERT_TRUE(open());
  EXPECT_LT(trial_seconds(), 0.1);
  EXPECT_NEAR(seconds_shown(), trial_seconds(), 1e-9);
  walk(120);
  EXPECT_GT(trial_seconds(), 1.9);
  EXPECT_NEAR(seconds_shown(), trial_seconds(), 1e-9);
}

// As where the machine stalls: the walks of a set stand still meanwhile, and it does not.
TEST_F(StimulusPage, IsWhereItShouldBeAlsoAfterFramesThatNobodySaw) {
  ASSERT_TRUE(open());
  for (int frame = 0; frame < 60; ++frame) bench_.frame();
  walk(1);
  EXPECT_GT(trial_seconds(), 0.9);
  EXPECT_NEAR(seconds_shown(), trial_seconds(), 1e-9);
}

TEST_F(StimulusPage, IsPausedByItsButtonAndByThePauseOfTheSession) {
  ASSERT_TRUE(open());
  walk(60);
  bench_.click("play");
  walk(2);
  const double stood = seconds_shown();
  walk(30);
  EXPECT_EQ(seconds_shown(), stood);
  bench_.click("play");
  walk(2);
  bench_.key(GLFW_KEY_ESCAPE);
  const double paused = seconds_shown();
  walk(60);
  bench_.click("resume");
  walk(1);
  EXPECT_LT(seconds_shown() - paused, 0.3);
}

TEST_F(StimulusPage, IsReplayedAsItWasShown) {
  ASSERT_TRUE(open());
  walk(90);
  bench_.click("speed");
  walk(90);
  bench_.click("play");
  walk(20);
  bench_.click("play");
  walk(40);
  const std::vector<Part> shown = bench_.view().stage().parts(Role::target);
  const std::int64_t began_us = bench_.session().trial()->started_us;
  ASSERT_TRUE(bench_.play(5));
  study::Database database = study::open_log(bench_.file().string());
  const study::StudyBundle bundle = *study::read_newest_study(database, interfaces());
  const study::LoggedSession log =
      study::read_session(database, study::session_uuids(database).at(0));
  TrialPlayer player(bundle, interfaces(), log, 0);
  player.move_to(shown_us_ - began_us);
  const std::vector<Part>& replayed = player.stage().parts(Role::target);
  ASSERT_EQ(replayed.size(), shown.size());
  // To the millisecond, at five metres a second.
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_LT((replayed[i].a - shown[i].a).norm(), 0.005f) << i;
  }
  player.move_to(shown_us_ - began_us - 1'000'000);
  EXPECT_GT((player.stage().parts(Role::target).back().a - shown.back().a).norm(), 0.02f);
}

}  // namespace
}  // namespace promenade::app
