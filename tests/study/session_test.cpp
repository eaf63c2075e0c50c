#include "study/session.h"

#include <gtest/gtest.h>

#include <cmath>

#include "play.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

constexpr std::int64_t second = 1'000'000;

// A study of one match trial with one interface, without practice and ratings.
std::string short_study(const std::string& interface, const std::string& task) {
  return "[study]\nname = 'short'\n[[interface]]\nname = '" + interface +
         "'\n[[task]]\nname = 'copy'\nkind = 'match'\n" + task;
}

const std::string far = "targets = [{example = 'far'}]\nthreshold = 'auto'\n";

TEST(Session, OpensItsPagesInOrder) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  EXPECT_EQ(player.session.page().kind, PageKind::welcome);
  player.at(1 * second, Continue{});
  EXPECT_EQ(player.session.page().kind, PageKind::consent);
  player.at(2 * second, Continue{});
  EXPECT_EQ(player.session.page().kind, PageKind::instructions);
  player.at(3 * second, Continue{});
  EXPECT_EQ(player.session.page().kind, PageKind::trial);
  player.at(4 * second, Done{});
  EXPECT_EQ(player.session.page().kind, PageKind::thanks);
  player.at(5 * second, Continue{});
  EXPECT_EQ(player.session.outcome(), Outcome::finished);
  EXPECT_EQ(player.all<SessionEnded>().at(0).t_us, 5 * second);
}

TEST(Session, EndsAsDeclinedAfterItsPage) {
  const StudyBundle bundle = toy::bundle();
  Player player(bundle);
  player.at(1, Decline{});  // not here
  player.at(2, Continue{});
  player.at(3, Decline{});
  EXPECT_EQ(player.session.page().kind, PageKind::declined);
  EXPECT_FALSE(player.session.ended());
  player.at(4, Continue{});
  EXPECT_EQ(player.session.outcome(), Outcome::declined);
}

TEST(Session, BeginsATrialAtTheAverageAndLogsIt) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(10);
  const TrialStarted started = player.all<TrialStarted>().at(0);
  const Sample first = player.all<Sample>().at(0);
  EXPECT_EQ(started.t_us, 10);
  EXPECT_EQ(started.d_first, first.d);
  EXPECT_TRUE(first.weights.isApprox(start_weights(bundle.space)));
  EXPECT_NEAR(*first.d,
              motion::distance(bundle.space.set, motion::blend(bundle.space, first.weights),
                               bundle.space.set.cycles[2])
                  .mean_m,
              1e-12);
}

TEST(Session, SucceedsAfterTheDwellTimeAtItsOwnTime) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(3 * second, toy::pick("far"));
  EXPECT_NEAR(*player.session.trial()->d, 0, 1e-9);
  player.at(3 * second + 499'999, Tick{});
  EXPECT_TRUE(player.session.trial());
  player.at(9 * second, Tick{});
  const TrialEnded ended = player.all<TrialEnded>().at(0);
  EXPECT_EQ(ended.outcome, TrialOutcome::success);
  EXPECT_EQ(ended.t_us, 3 * second + 500'000);
  EXPECT_EQ(ended.first_below_us, 3 * second);
  EXPECT_EQ(ended.changes, 1);
}

TEST(Session, DoesNotSucceedByPassingThroughTheTarget) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(3 * second, toy::pick("far"));
  player.at(3 * second + 499'999, toy::pick("near"));
  player.at(20 * second, Tick{});
  ASSERT_TRUE(player.session.trial());
  player.at(21 * second, Done{});
  const TrialEnded ended = player.all<TrialEnded>().at(0);
  EXPECT_EQ(ended.outcome, TrialOutcome::done);
  EXPECT_EQ(ended.first_below_us, 3 * second);
  EXPECT_NEAR(*ended.d_best, 0, 1e-9);
  EXPECT_GT(*ended.d_final, 0.1);
}

TEST(Session, CountsTheDwellTimeFromTheLastChange) {
  const StudyBundle bundle =
      toy::bundle(short_study("mix", "targets = [{example = 'far'}]\nthreshold = 0.1\n"));
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, toy::slide("far", 0.5));
  player.at(1 * second + 400'000, toy::slide("near", 0.01));
  player.at(5 * second, Tick{});
  const TrialEnded ended = player.all<TrialEnded>().at(0);
  EXPECT_EQ(ended.t_us, 1 * second + 900'000);
  EXPECT_EQ(ended.first_below_us, 1 * second);
}

TEST(Session, LeavesTheDwellTimeRunningWhenAControlChangesNothing) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(3 * second, toy::pick("far"));
  const std::size_t samples = player.all<Sample>().size();
  player.at(3 * second + 400'000, toy::pick("far"));
  EXPECT_EQ(player.all<Sample>().size(), samples);
  player.at(9 * second, Tick{});
  const TrialEnded ended = player.all<TrialEnded>().at(0);
  EXPECT_EQ(ended.t_us, 3 * second + 500'000);
  EXPECT_EQ(ended.changes, 1);
}

TEST(Session, LogsOnlyTheNumbersThatAControlHas) {
  const StudyBundle bundle = toy::bundle(short_study("mix", far));
  Player player(bundle);
  player.to_trial(0);
  const Event slid = std::get<Event>(player.at(1 * second, toy::slide("far", 0)).at(0));
  const Event picked = std::get<Event>(player.at(2 * second, toy::pick("far")).at(0));
  EXPECT_EQ(slid.value, 0.0);
  EXPECT_EQ(picked.value, std::nullopt);
  for (const Event& event : {slid, picked}) EXPECT_TRUE(!event.x && !event.y) << event.kind;
}

TEST(Session, SucceedsAtOnceWithoutADwellTime) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far + "dwell_ms = 0\n"));
  Player player(bundle);
  player.to_trial(0);
  player.at(7, toy::pick("far"));
  EXPECT_EQ(player.all<TrialEnded>().at(0).t_us, 7);
}

TEST(Session, TimesOutAtTheLimitHoweverLateTheNextInput) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far + "limit_s = 45\n"));
  Player player(bundle);
  player.to_trial(5 * second);
  player.at(100 * second, toy::pick("far"));
  const TrialEnded ended = player.all<TrialEnded>().at(0);
  EXPECT_EQ(ended.outcome, TrialOutcome::timeout);
  EXPECT_EQ(ended.t_us, 50 * second);
  EXPECT_EQ(ended.changes, 0);
  EXPECT_EQ(player.all<Sample>().size(), 1U);
}

TEST(Session, LetsADwellTimeThatEndsAtTheLimitWin) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far + "limit_s = 45\n"));
  for (const std::int64_t late : {0, 1}) {
    Player player(bundle);
    player.to_trial(0);
    player.at(44 * second + 500'000 + late, toy::pick("far"));
    player.at(60 * second, Tick{});
    const TrialEnded ended = player.all<TrialEnded>().at(0);
    EXPECT_EQ(ended.t_us, 45 * second);
    EXPECT_EQ(ended.outcome, late ? TrialOutcome::timeout : TrialOutcome::success);
  }
}

TEST(Session, NeverWinsBeforeAnythingWasTouched) {
  StudyBundle bundle = toy::bundle(short_study("pick", far));
  bundle.study.tasks[0].threshold_m = 100;  // check refuses this; the session must hold too
  Player player(bundle);
  player.to_trial(0);
  player.at(60 * second, Tick{});
  ASSERT_TRUE(player.session.trial());
  player.at(61 * second, Done{});
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::done);
}

TEST(Session, TakesDoneBelowTheThresholdAsSuccess) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(10, toy::pick("far"));
  player.at(20, Done{});
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::success);
}

TEST(Session, StartsOverAtTheStateInWhichTheTrialBegan) {
  const StudyBundle bundle = toy::bundle(short_study("mix", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(10, toy::slide("near", 1));
  player.at(20, StartOver{});
  EXPECT_FALSE(player.session.trial()->touched);
  player.at(30, toy::slide("side", 0.5));
  const std::vector<Sample> samples = player.all<Sample>();
  ASSERT_EQ(samples.size(), 4U);
  EXPECT_EQ(samples[2].weights, samples[0].weights);
  EXPECT_EQ(samples[3].weights, Eigen::Vector3d(0, 1, 0));
  EXPECT_EQ(player.session.trial()->summary.changes, 2);
}

TEST(Session, LogsARefusedControlWithoutASample) {
  const StudyBundle bundle = toy::bundle(short_study("mix", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(10, toy::slide("nobody", 1));
  const Event event = player.all<Event>().back();
  EXPECT_EQ(event.kind, "slide");
  EXPECT_EQ(event.detail, R"({"applied":false})");
  EXPECT_EQ(player.all<Sample>().size(), 1U);
  EXPECT_EQ(player.session.trial()->summary.changes, 0);
  EXPECT_FALSE(player.session.trial()->touched);
}

TEST(Session, CountsClicksAndLateFramesOfTheTrialOnly) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.at(0, Press{});
  player.to_trial(1);
  player.at(2, Press{});
  player.at(3, Press{});
  player.at(4, LateFrame{9000});
  player.at(5, Done{});
  const TrialEnded ended = player.all<TrialEnded>().at(0);
  EXPECT_EQ(ended.clicks, 2);
  EXPECT_EQ(ended.late_frames, 1);
}

TEST(Session, AbortsTheRunningTrialWhenItIsStopped) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(10, Stop{"window \"closed\""});
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::aborted);
  EXPECT_EQ(player.session.outcome(), Outcome::stopped);
  EXPECT_TRUE(player.at(11, Tick{}).empty());
  EXPECT_EQ(player.all<Event>().back().detail, R"({"reason":"window \"closed\""})");
}

TEST(Session, HasFinishedWhenTheLastPageIsClosed) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(0);
  player.at(10, Done{});
  player.at(20, Stop{});
  EXPECT_EQ(player.session.outcome(), Outcome::finished);
}

TEST(Session, AsksForAllRatingsAndLogsThem) {
  const StudyBundle bundle =
      toy::bundle(short_study("pick", far) + "[[rating]]\nitem = 'liked'\nquestion = 'How?'\n");
  Player player(bundle);
  player.to_trial(0);
  player.at(10, Done{});
  EXPECT_EQ(player.session.page().kind, PageKind::questionnaire);
  EXPECT_FALSE(player.session.can_continue());
  player.at(20, Continue{});
  player.at(30, SetAnswer{"liked", 8});    // not on the scale
  player.at(31, SetAnswer{"liked", 2.5});  // between its points
  EXPECT_FALSE(player.session.can_continue());
  player.at(40, SetAnswer{"liked", 6});
  player.at(50, Continue{});
  const std::vector<Answer> answers = player.all<Answer>();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].value, 6.0);
  EXPECT_EQ(answers[0].t_us, 40);
  EXPECT_EQ(answers[0].trial, 0);
  EXPECT_EQ(player.session.page().kind, PageKind::thanks);
}

TEST(Session, SaysWhoDidWhat) {
  const StudyBundle bundle = toy::bundle(short_study("pick", far));
  Player player(bundle);
  player.to_trial(0);
  for (const Event& event : player.all<Event>()) {
    const bool by_system = event.kind == "page" || event.kind == "start";
    EXPECT_EQ(event.actor, by_system ? Actor::system : Actor::participant) << event.kind;
  }
}

TEST(Session, GivesRecordsInTheOrderOfTheirTimes) {
  const StudyBundle bundle = toy::bundle();
  Player player(bundle);
  player.whole_session();
  std::int64_t last = 0;
  for (const Record& record : player.records) {
    if (std::holds_alternative<Answer>(record)) continue;  // given earlier, confirmed now
    const std::int64_t t = std::visit([](const auto& r) { return r.t_us; }, record);
    EXPECT_GE(t, last);
    last = t;
  }
  EXPECT_EQ(player.session.outcome(), Outcome::finished);
  EXPECT_EQ(player.all<TrialEnded>().size(), player.session.plan().trials.size());
}

TEST(Session, ReproducesEverySampleFromTheLoggedControls) {
  const StudyBundle bundle = toy::bundle(short_study("mix", "targets = [{example = 'far'}]\n"));
  Player player(bundle);
  player.to_trial(0);
  Rng rng(3, 0, "test");
  const std::vector<std::string> walks = {"near", "side", "far", "nobody"};
  for (std::int64_t t = 10; t < 2000; t += 10) {
    if (rng.below(20) == 0) player.at(t, StartOver{});
    player.at(t, toy::slide(walks[rng.below(4)], rng.uniform()));
  }
  Player again(bundle);
  again.to_trial(0);
  for (const Event& event : player.all<Event>()) {
    if (event.kind == "start_over") again.at(event.t_us, StartOver{});
    if (event.detail.empty()) continue;
    if (event.kind == "start") continue;
    again.at(event.t_us,
             Control{{.kind = event.kind, .target = event.target, .value = *event.value}});
  }
  const std::vector<Sample> one = player.all<Sample>();
  const std::vector<Sample> two = again.all<Sample>();
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].weights, two[i].weights);
    EXPECT_EQ(one[i].d, two[i].d);
  }
}

}  // namespace
}  // namespace promenade::study
