// Undo, redo and the first touch.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "play.h"
#include "study/simulate.h"
#include "toy.h"

namespace promenade::study {
namespace {

using toy::Player;

// One match trial with the sliders, opened at time 10.
struct Sliding {
  StudyBundle bundle = toy::bundle(
      "[study]\nname = 'short'\n[[interface]]\nname = 'mix'\n[[task]]\nname = 'copy'\n"
      "kind = 'match'\ntargets = [{example = 'far'}]\n");
  Player player{bundle};

  Sliding() { player.to_trial(10); }
  const TrialState& trial() const { return *player.session.trial(); }
  // A drag: a press of the mouse and some places on the way.
  void drag(std::int64_t t_us, const std::string& walk, double value) {
    player.at(t_us, Press{});
    for (int k = 1; k <= 4; ++k) player.at(t_us + k, toy::slide(walk, value * k / 4));
  }
};

TEST(Undo, TakesBackAWholeDrag) {
  Sliding one;
  one.drag(100, "near", 1);
  const Eigen::VectorXd before = one.trial().weights;
  one.drag(200, "side", 0.5);
  one.player.at(300, Undo{});
  EXPECT_EQ(one.trial().weights, before);
}

TEST(Undo, GoesBackToTheStartAndNoFurther) {
  Sliding one;
  const Eigen::VectorXd start = one.trial().weights;
  one.drag(100, "near", 1);
  one.player.at(300, Undo{});
  EXPECT_EQ(one.trial().weights, start);
  EXPECT_FALSE(one.trial().touched);
  one.player.at(301, Undo{});
  EXPECT_EQ(one.player.all<Event>().back().detail, R"({"applied":false})");
}

TEST(Undo, RedoDoesItAgain) {
  Sliding one;
  one.drag(100, "near", 1);
  one.drag(200, "side", 0.5);
  const Eigen::VectorXd last = one.trial().weights;
  one.player.at(300, Undo{});
  one.player.at(301, Undo{});
  one.player.at(302, Redo{});
  one.player.at(303, Redo{});
  EXPECT_EQ(one.trial().weights, last);
}

TEST(Undo, SomethingNewEndsRedo) {
  Sliding one;
  one.drag(100, "near", 1);
  one.player.at(300, Undo{});
  one.drag(400, "side", 1);
  one.player.at(500, Redo{});
  EXPECT_EQ(one.player.all<Event>().back().detail, R"({"applied":false})");
}

TEST(Undo, TakesBackStartOver) {
  Sliding one;
  one.drag(100, "near", 1);
  const Eigen::VectorXd before = one.trial().weights;
  one.player.at(200, StartOver{});
  EXPECT_NE(one.trial().weights, before);
  one.player.at(300, Undo{});
  EXPECT_EQ(one.trial().weights, before);
}

TEST(Undo, ARestBeginsANewStep) {
  Sliding one;
  one.player.at(100, toy::slide("near", 1));
  const Eigen::VectorXd before = one.trial().weights;
  one.player.at(3'000'000, toy::slide("near", 0.5));
  one.player.at(3'000'001, toy::slide("side", 0.5));
  one.player.at(3'000'002, Undo{});
  one.player.at(3'000'003, Undo{});
  EXPECT_EQ(one.trial().weights, before);
}

TEST(Undo, IsLoggedWithWhatItShows) {
  Sliding one;
  one.drag(100, "near", 1);
  const std::size_t samples = one.player.all<Sample>().size();
  one.player.at(300, Undo{});
  EXPECT_EQ(one.player.all<Event>().back().kind, "undo");
  EXPECT_EQ(one.player.all<Sample>().size(), samples + 1);
}

TEST(Undo, TwoPicksInARowAreTwoSteps) {
  const StudyBundle bundle = toy::bundle(
      "[study]\nname = 'short'\n[[interface]]\nname = 'pick'\n[[task]]\nname = 'copy'\n"
      "kind = 'match'\ntargets = [{example = 'far'}]\n");
  Player player(bundle);
  player.to_trial(10);
  player.at(100, toy::pick("near"));
  player.at(101, toy::pick("near"));
  EXPECT_EQ(player.session.trial()->history.undo.size(), 2U);
}

TEST(Changes, ADragIsOneAndWhatShowsTheSameIsNone) {
  Sliding one;
  one.drag(100, "near", 1);
  one.drag(200, "side", 0.5);
  one.drag(300, "side", 0.5);  // ends where it was; on the way it was elsewhere
  one.player.at(400, Press{});
  one.player.at(401, toy::slide("side", 0.5));
  EXPECT_EQ(one.trial().summary.changes, 3);
}

TEST(Blind, SimulatedPeoplePressDone) {
  const StudyBundle bundle = toy::bundle(
      "[study]\nname = 'short'\n[[interface]]\nname = 'pick'\n[[task]]\nname = 'copy'\n"
      "kind = 'match'\nblind = true\nthreshold = 'auto'\ntargets = [{example = 'far'}]\n");
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    int done = 0;
    for (const Record& record :
         simulate_session(bundle, toy::registry(), make_plan(bundle.study, 0), seed)) {
      const auto* event = std::get_if<Event>(&record);
      done += event && event->kind == "done";
    }
    EXPECT_EQ(done, 1) << seed;
  }
}

TEST(FirstTouch, IsMarkedOnceForEachControl) {
  Sliding one;
  one.drag(100, "near", 1);
  one.drag(200, "side", 1);
  one.drag(300, "near", 0.5);
  std::vector<std::string> marked;
  for (const Event& event : one.player.all<Event>()) {
    if (event.detail.find(R"("first":true)") != std::string::npos) marked.push_back(event.target);
  }
  EXPECT_EQ(marked, (std::vector<std::string>{"near", "side"}));
}

TEST(FirstTouch, TheSystemsValuesStandAtTheStart) {
  Sliding one;
  for (const Event& event : one.player.all<Event>()) {
    if (event.kind != "start") continue;
    EXPECT_EQ(event.actor, Actor::system);
    const auto controls = nlohmann::json::parse(event.detail).at("controls");
    ASSERT_EQ(controls.size(), 3U);
    EXPECT_EQ(controls[0].at("kind"), "slide");
    EXPECT_EQ(controls[0].at("value"), 0);
  }
}

TEST(Blind, DoesNotEndByItselfButCountsAtDone) {
  const StudyBundle bundle = toy::bundle(
      "[study]\nname = 'short'\n[[interface]]\nname = 'pick'\n[[task]]\nname = 'copy'\n"
      "kind = 'match'\nblind = true\nthreshold = 'auto'\ntargets = [{example = 'far'}]\n");
  Player player(bundle);
  player.to_trial(10);
  player.at(100, toy::pick("far"));
  player.at(5'000'000, Tick{});
  ASSERT_TRUE(player.session.trial());
  player.at(6'000'000, Done{});
  EXPECT_EQ(player.all<TrialEnded>().at(0).outcome, TrialOutcome::success);
}

}  // namespace
}  // namespace promenade::study
