// What a replay shows is a function of the log and the time alone.
#include "app/trial_player.h"

#include <gtest/gtest.h>

#include "app/registry.h"
#include "tests/app/logged_trial.h"

namespace promenade::app {
namespace {

using bench::LoggedTrial;
using bench::played_trial;

struct Seen {
  Eigen::VectorXd weights;
  std::optional<double> d;
  double phase = 0;
  Orbit orbit;
  bool operator==(const Seen& other) const {
    return weights == other.weights && d == other.d && phase == other.phase && orbit == other.orbit;
  }
};

Seen seen(TrialPlayer& player) {
  return {player.weights(), player.d(), player.stage().phase(), player.stage().orbit()};
}

// At every sixth of a second, with this many frames a second.
std::vector<Seen> play(const LoggedTrial& played, std::int64_t fps) {
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  std::vector<Seen> all;
  for (std::int64_t frame = 0; frame * 1'000'000 / fps < player.length_us(); ++frame) {
    player.move_to(frame * 1'000'000 / fps);
    if (frame % (fps / 6) == 0) all.push_back(seen(player));
  }
  return all;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const study::InterfaceType& type : interfaces().all()) names.push_back(type.name);
  return names;
}

class EveryReplayedInterface : public testing::TestWithParam<std::string> {};

TEST_P(EveryReplayedInterface, ShowsTheSameAtThirtyAndAtHundredFortyFourFramesASecond) {
  const LoggedTrial played = played_trial(GetParam());
  const std::vector<Seen> slow = play(played, 30);
  const std::vector<Seen> fast = play(played, 144);
  ASSERT_EQ(slow.size(), fast.size());
  ASSERT_GT(slow.size(), 30U);
  for (std::size_t i = 0; i < slow.size(); ++i) EXPECT_EQ(slow[i], fast[i]) << i;
  EXPECT_NE(slow.front().weights, slow.back().weights);
}

TEST_P(EveryReplayedInterface, ShowsAtTheTimeOfASampleWhatWasShownThen) {
  const LoggedTrial played = played_trial(GetParam());
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  int samples = 0;
  for (const study::LoggedStep& step : played.log.steps) {
    if (!step.sample) continue;
    ++samples;
    player.move_to(step.shown.t_us - player.trial().started_us);
    EXPECT_EQ(player.weights(), step.shown.weights);
    EXPECT_EQ(player.d(), step.shown.d);
  }
  EXPECT_GT(samples, 5);
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryReplayedInterface, testing::ValuesIn(all_names()),
                         [](const auto& test) { return test.param; });

TEST(TrialPlayer, GoesBackToWhatItShowed) {
  const LoggedTrial played = played_trial("map");
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  player.move_to(2'000'000);
  const Seen before = seen(player);
  player.move_to(player.length_us());
  EXPECT_FALSE(seen(player) == before);
  player.move_to(2'000'000);
  EXPECT_EQ(seen(player), before);
}

TEST(TrialPlayer, EndsWithTheLastPictureOfTheTrial) {
  const LoggedTrial played = played_trial("labels");
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  player.move_to(INT64_MAX);
  EXPECT_EQ(player.t_us(), player.length_us());
  ASSERT_NE(player.session().trial(), nullptr);
  EXPECT_EQ(player.d(), played.log.trials[0].ended.d_final);
}

TEST(TrialPlayer, PlaysWhatIsKnownOfATrialThatWasCutOff) {
  LoggedTrial played = played_trial("labels", 3);
  played.log.trials[0].outcome.clear();
  played.log.steps.resize(played.log.steps.size() / 2);
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  player.move_to(INT64_MAX);
  EXPECT_GE(player.session_us(), played.log.steps.back().t_us());
  EXPECT_LT(player.session_us(), played.log.steps.back().t_us() + 1000);
}

TEST(TrialPlayer, RefusesALogThatLeadsElsewhere) {
  LoggedTrial played = played_trial("labels", 3);
  study::LoggedStep done;
  done.trial = 0;
  done.event.kind = "done";
  done.event.t_us = played.log.trials[0].started_us + 500'000;
  const auto later = [&](const study::LoggedStep& one) { return one.t_us() > done.event.t_us; };
  auto& steps = played.log.steps;
  steps.insert(std::find_if(steps.begin(), steps.end(), later), done);
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  EXPECT_THROW(player.move_to(player.length_us()), InputError);
}

TEST(TrialPlayer, StandsStillWhileTheTrialIsPaused) {
  const LoggedTrial played = played_trial("features", 20);
  TrialPlayer player(played.bundle, interfaces(), played.log, 0);
  int paused = 0;
  for (std::int64_t t_us = 0; t_us < player.length_us(); t_us += 10'000) {
    const Seen before = seen(player);
    const bool was_paused = player.session().paused();
    player.move_to(t_us);
    if (!was_paused || !player.session().paused()) continue;
    ++paused;
    EXPECT_EQ(seen(player), before);
  }
  EXPECT_GT(paused, 10);
}

}  // namespace
}  // namespace promenade::app
