// Pauses, breaks and the choice of a language: pages and clocks that wait.
#include <gtest/gtest.h>

#include <algorithm>

#include "play.h"
#include "study/session.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

constexpr std::int64_t second = 1'000'000;

// One match trial of ten seconds, which "far" wins after two of them.
std::string timed_study() {
  return "[study]\nname = 'short'\n[[interface]]\nname = 'pick'\n[[task]]\nname = 'copy'\n"
         "kind = 'match'\nlimit_s = 10\nthreshold = 'auto'\ndwell_ms = 2000\n"
         "targets = [{example = 'far'}]\n";
}

class PausedTrial : public testing::Test {
 protected:
  PausedTrial() { player_.to_trial(0); }
  TrialEnded ended() const { return player_.all<TrialEnded>().at(0); }

  const StudyBundle bundle_ = toy::bundle(timed_study());
  Player player_{bundle_};
};

TEST_F(PausedTrial, HasTheWholeLimitWithoutThePause) {
  player_.at(4 * second, Pause{});
  player_.at(100 * second, Resume{});
  player_.at(105 * second, Tick{});
  EXPECT_NE(player_.session.trial(), nullptr);
  player_.at(107 * second, Tick{});
  EXPECT_EQ(ended().outcome, TrialOutcome::timeout);
  EXPECT_EQ(ended().t_us, 106 * second);
  EXPECT_EQ(ended().paused_us, 96 * second);
}

TEST_F(PausedTrial, IsNotOverWhileItStands) {
  player_.at(9 * second, Pause{});
  player_.at(500 * second, Tick{});
  EXPECT_TRUE(player_.session.paused());
  EXPECT_NE(player_.session.trial(), nullptr);
}

TEST_F(PausedTrial, IsOverBeforeAPauseThatComesTooLate) {
  player_.at(11 * second, Pause{});
  EXPECT_EQ(ended().t_us, 10 * second);
  EXPECT_EQ(ended().paused_us, 0);
}

TEST_F(PausedTrial, KeepsTheDwellTimeThatHadPassed) {
  player_.at(1 * second, toy::pick("far"));
  player_.at(2 * second, Pause{});
  player_.at(60 * second, Resume{});
  player_.at(60 * second + 999'999, Tick{});
  EXPECT_NE(player_.session.trial(), nullptr);
  player_.at(61 * second, Tick{});
  EXPECT_EQ(ended().outcome, TrialOutcome::success);
  EXPECT_EQ(ended().t_us, 61 * second);
}

TEST_F(PausedTrial, TakesNothingButResumeAndStop) {
  player_.at(1 * second, Pause{});
  const Eigen::VectorXd before = player_.session.trial()->weights;
  const std::size_t logged = player_.records.size();
  const decltype(Input::action) tried[] = {toy::pick("far"), Done{},  StartOver{}, Undo{},
                                           Press{},          Pause{}, Continue{},  Camera{}};
  for (const auto& action : tried) player_.at(2 * second, action);
  EXPECT_EQ(player_.records.size(), logged);
  EXPECT_EQ(player_.session.trial()->weights, before);
}

TEST_F(PausedTrial, CountsOnlyWhatStoodWhenItIsStopped) {
  player_.at(3 * second, Pause{});
  player_.at(90 * second, Stop{"closed"});
  EXPECT_EQ(ended().outcome, TrialOutcome::aborted);
  EXPECT_EQ(ended().paused_us, 87 * second);
}

TEST_F(PausedTrial, AddsItsPausesUp) {
  for (const std::int64_t t : {1, 11}) {
    player_.at(t * second, Pause{});
    player_.at((t + 5) * second, Resume{});
  }
  EXPECT_EQ(player_.session.trial()->control_us(20 * second), 10 * second);
}

TEST_F(PausedTrial, LogsWhoPausedItAndWhoWentOn) {
  player_.at(3 * second, Pause{});
  player_.at(4 * second, Resume{});
  std::vector<std::string> kinds;
  for (const Event& event : player_.all<Event>()) {
    if (event.kind != "pause" && event.kind != "resume") continue;
    kinds.push_back(event.kind);
    EXPECT_EQ(event.actor, Actor::participant);
    EXPECT_EQ(event.trial, 0);
  }
  EXPECT_EQ(kinds, (std::vector<std::string>{"pause", "resume"}));
}

// Glides to "far" within ten seconds of its only input.
class Glide final : public InterfaceState {
 public:
  std::unique_ptr<InterfaceState> clone() const override { return std::make_unique<Glide>(*this); }
  Applied apply(const ControlInput& input) override {
    since_us_ = input.t_us;
    return Applied::done;
  }
  void weights(std::int64_t t_us, Eigen::VectorXd& weights) const override {
    const double share = std::clamp(static_cast<double>(t_us - since_us_) / 1e7, 0.0, 1.0);
    weights.resize(3);
    weights << 1 - share, 0, share;
  }

 private:
  std::int64_t since_us_ = 0;
};

InterfaceRegistry gliding_registry() {
  InterfaceRegistry registry;
  InterfaceType type;
  type.name = "pick";
  type.start = [](const InterfaceContext&) { return std::make_unique<Glide>(); };
  registry.add(std::move(type));
  return registry;
}

TEST(Pause, HoldsAGlideWhereItIs) {
  const InterfaceRegistry registry = gliding_registry();
  const StudyBundle bundle =
      read_study("toy.toml", timed_study(), registry,
                 [](const std::string&, const std::string&) { return toy::motion_set(); });
  Session session(bundle, registry, make_plan(bundle.study, 0));
  const auto at = [&](std::int64_t seconds, decltype(Input::action) action) {
    Input input;
    input.t_us = seconds * second;
    input.action = std::move(action);
    session.step(input);
  };
  for (int page = 0; page < 3; ++page) at(0, Continue{});
  at(1, toy::pick("far"));
  at(3, Tick{});
  EXPECT_NEAR(session.trial()->weights(2), 0.2, 1e-12);
  at(3, Pause{});
  at(60, Resume{});
  at(61, Tick{});
  EXPECT_NEAR(session.trial()->weights(2), 0.3, 1e-12);
  at(62, toy::pick("far"));
  at(63, Tick{});
  EXPECT_NEAR(session.trial()->weights(2), 0.1, 1e-12) << "an input after the pause begins anew";
}

TEST(Pause, OfAPageOfTextLeavesItWhereItWas) {
  const StudyBundle bundle = toy::bundle();
  Player player(bundle);
  player.at(1, Continue{});
  player.at(2, Pause{});
  player.at(3, Continue{});
  EXPECT_EQ(player.session.page().kind, PageKind::consent);
  player.at(4, Resume{});
  player.at(5, Continue{});
  EXPECT_EQ(player.session.page().kind, PageKind::instructions);
}

TEST(JustEnded, IsToldOnTheNextPageAndNoLonger) {
  const StudyBundle bundle = toy::bundle();
  Player player(bundle);
  player.to_trial(0);
  player.at(46 * second, Tick{});  // practice, out of time
  ASSERT_TRUE(player.session.just_ended());
  EXPECT_EQ(player.session.just_ended()->outcome, TrialOutcome::timeout);
  player.at(50 * second, Continue{});
  player.at(51 * second, Done{});
  EXPECT_EQ(player.session.just_ended()->outcome, TrialOutcome::done);
}

TEST(JustEnded, IsNotToldOfABlindTrial) {
  const StudyBundle bundle = toy::bundle(timed_study() + "blind = true\n");
  Player player(bundle);
  player.to_trial(0);
  player.at(1 * second, toy::pick("far"));
  player.at(2 * second, Done{});
  EXPECT_FALSE(player.session.just_ended());
}

std::string study_with_breaks(const std::string& least) {
  return toy::study_text() + "[breaks]\nafter = 'block'\nleast_s = " + least + "\n";
}

void play_to_break(Player& player) {
  for (std::int64_t t = second; player.session.page().kind != PageKind::break_; t += second) {
    ASSERT_FALSE(player.session.ended());
    if (player.session.trial()) {
      player.at(t, Done{});
    } else {
      for (std::size_t i = 0; i < player.session.answers().size(); ++i) {
        player.at(t, SetAnswer{"liked", 7});
      }
      player.at(t, Continue{});
    }
  }
}

TEST(Break, LastsAsLongAsTheStudyAsks) {
  const StudyBundle bundle = toy::bundle(study_with_breaks("30"));
  Player player(bundle);
  play_to_break(player);
  const std::int64_t opened = player.all<Event>().back().t_us;
  EXPECT_FALSE(player.session.can_continue());
  player.at(opened + 29 * second, Continue{});
  EXPECT_EQ(player.all<Event>().back().kind, "continue_refused");
  EXPECT_EQ(player.session.break_left_us(), second);
  player.at(opened + 30 * second, Continue{});
  EXPECT_EQ(player.session.page().kind, PageKind::instructions);
}

TEST(Break, MayEndAtOnceWhereNoTimeIsAsked) {
  const StudyBundle bundle = toy::bundle(study_with_breaks("0"));
  Player player(bundle);
  play_to_break(player);
  EXPECT_TRUE(player.session.can_continue());
}

TEST(ChoiceOfLanguage, ComesFirstAndIsLogged) {
  const StudyBundle bundle = toy::bundle();
  Session session(bundle, toy::registry(), make_plan(bundle.study, 0), true);
  EXPECT_EQ(session.page().kind, PageKind::language);
  EXPECT_FALSE(session.can_continue());
  Input input;
  input.t_us = 5;
  input.action = ChooseLanguage{"xx"};
  session.step(input);
  EXPECT_EQ(session.page().kind, PageKind::language) << "a language that is not offered";
  input.action = ChooseLanguage{"en"};
  const std::vector<Record> records = session.step(input);
  EXPECT_EQ(std::get<Event>(records.at(0)).kind, "language");
  EXPECT_EQ(std::get<Event>(records.at(0)).target, "en");
  EXPECT_EQ(session.language(), "en");
  EXPECT_EQ(session.page().kind, PageKind::welcome);
}

}  // namespace
}  // namespace promenade::study
