#include "app/stage.h"

#include <gtest/gtest.h>

#include "tests/app/panel_bench.h"
#include "tests/motion/allocations.h"

namespace promenade::app {
namespace {

const motion::MotionSet& set() { return bench::space().set; }
const motion::PoseBank& bank() {
  static const motion::PoseBank made = motion::make_pose_bank(bench::space());
  return made;
}
const motion::Cycle& cycle(const std::string& name) {
  return set().cycles[static_cast<std::size_t>(motion::find_cycle(set(), name))];
}

TEST(Stage, AChangeOfStyleKeepsThePhase) {
  Stage stage(set(), bank());
  stage.advance(0, {.created = &cycle("sad")});
  stage.advance(400'000, {.created = &cycle("sad")});
  const double before = stage.phase();
  stage.advance(400'000, {.created = &cycle("proud")});
  EXPECT_EQ(stage.phase(), before);
}

TEST(Stage, TheTargetSetsThePace) {
  Stage alone(set(), bank());
  Stage both(set(), bank());
  for (const std::int64_t t : {0, 300'000}) {
    alone.advance(t, {.created = &cycle("old")});
    both.advance(t, {.target = &cycle("old"), .created = &cycle("happy")});
  }
  EXPECT_EQ(both.phase(), alone.phase());
}

TEST(Stage, AReferenceLeavesThePaceToWhatIsCreated) {
  Stage alone(set(), bank());
  Stage both(set(), bank());
  for (const std::int64_t t : {0, 300'000}) {
    alone.advance(t, {.created = &cycle("old")});
    both.advance(t, {.created = &cycle("old"), .reference = &cycle("happy")});
  }
  EXPECT_EQ(both.phase(), alone.phase());
  EXPECT_TRUE(both.shows(Role::reference));
}

TEST(Stage, StandsStillInAPauseAndWalksHalfAsFastInSlowMotion) {
  Stage stage(set(), bank());
  const motion::Cycle& walk = cycle("normal");
  stage.advance(0, {.created = &walk});
  stage.pace().playing = false;
  stage.advance(200'000, {.created = &walk});
  EXPECT_EQ(stage.phase(), 0);
  stage.pace() = {.playing = true, .speed = 0.5};
  stage.advance(400'000, {.created = &walk});
  // 0.2 s at half speed, from the first keytime on.
  EXPECT_NEAR(motion::seconds_at(set(), walk, stage.phase()), 0.1, 1e-12);
}

TEST(Stage, FiguresShareTheStageFromLeftToRight) {
  Stage stage(set(), bank());
  const StagePlan plan = make_layout(1280, 720).stage_plan(false);
  stage.advance(0,
                {.target = &cycle("old"), .created = &cycle("sad"), .reference = &cycle("normal")});
  EXPECT_LT(stage.plate(plan, Role::target).x(), stage.plate(plan, Role::reference).x());
  EXPECT_LT(stage.plate(plan, Role::reference).x(), stage.plate(plan, Role::created).x());
}

TEST(Stage, ABlindTaskKeepsThePlaceOfTheHiddenFigure) {
  Stage stage(set(), bank());
  stage.advance(0, {.target = &cycle("old"), .created = &cycle("sad"), .blind = true});
  EXPECT_TRUE(stage.shows(Role::created));
  EXPECT_TRUE(stage.hides(Role::created));
  EXPECT_FALSE(stage.hides(Role::target));
}

TEST(Stage, AStepOfTimeAllocatesNothing) {
#if PROMENADE_COUNTS_ALLOCATIONS
  Stage stage(set(), bank());
  for (std::int64_t t = 0; t < 200'000; t += 16'667) {
    stage.advance(t, {.target = &cycle("old"), .created = &cycle("sad")});
  }
  const long before = motion::allocations();
  stage.advance(216'671, {.target = &cycle("old"), .created = &cycle("happy")});
  EXPECT_EQ(motion::allocations(), before);
#else
  GTEST_SKIP() << "the sanitizer brings its own malloc";
#endif
}

TEST(SmallFigures, AskingAgainForTheSameAllocatesNothing) {
#if PROMENADE_COUNTS_ALLOCATIONS
  Stage stage(set(), bank());
  const Eigen::VectorXd even = study::start_weights(bench::space());
  const auto ask = [&] {
    stage.small_figures().clear();
    for (int k = 0; k < 9; ++k) stage.small_figures().ask({}, {}, even, Rgb::Zero());
  };
  ask();
  const long before = motion::allocations();
  ask();
  EXPECT_EQ(motion::allocations(), before);
#else
  GTEST_SKIP() << "the sanitizer brings its own malloc";
#endif
}

}  // namespace
}  // namespace promenade::app
