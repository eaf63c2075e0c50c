#include "motion/set_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/set_file.h"
#include "tests/motion/walker.h"
#include "tests/test_folder.h"

namespace promenade::motion {
namespace {

const MotionSet& walkers() {
  static const MotionSet set = builtin_set("A").value();
  return set;
}

std::string own_file(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  static const TestFolder folder;
  return folder.file(std::string(test->name()) + "/" + name);
}

// A take of walker `i` on disk, its figure of another size.
TakeSource recorded(std::size_t i, double scale = 1, int repeats = 4) {
  const Cycle& cycle = walkers().cycles[i];
  Clip clip = walker_clip(walkers(), cycle, repeats);
  for (Joint& joint : clip.skeleton.joints) joint.offset *= scale;
  clip.values.topRows<3>() *= scale;
  const std::string file = own_file(cycle.style + ".bvh");
  write_file(file, bvh_text(clip));
  return {file, cycle.style + ".bvh", cycle.style};
}

SetOptions in_metres() {
  SetOptions options;
  options.name = "walkers";
  options.figure.unit_m = 1;
  return options;
}

double slide(const MotionSet& set, const Cycle& cycle) {
  return std::max(stance_slide_m(set, cycle, Side::left), stance_slide_m(set, cycle, Side::right));
}

TEST(BuildSet, FindsTheCycleThatAWalkerRepeats) {
  const BuiltSet built = build_set({recorded(0), recorded(1), recorded(2)}, {});
  ASSERT_EQ(built.set.size(), 3);
  for (const Cycle& cycle : built.set.cycles) {
    EXPECT_EQ(cycle.name, cycle.style + "_1");
    const auto original = std::find_if(walkers().cycles.begin(), walkers().cycles.end(),
                                       [&](const Cycle& c) { return c.style == cycle.style; });
    EXPECT_NEAR(cycle.seconds, original->seconds, 0.02);
    EXPECT_LT(cycle.loop_error_m, 0.005);
    EXPECT_LT(slide(built.set, cycle), 0.008);
  }
}

TEST(BuildSet, DoesNotDependOnTheOrderOfTakes) {
  std::vector<TakeSource> sources = {recorded(0), recorded(1), recorded(2)};
  const std::string bytes = to_bytes(build_set(sources, {}).set);
  std::reverse(sources.begin(), sources.end());
  EXPECT_EQ(to_bytes(build_set(sources, {}).set), bytes);
}

TEST(BuildSet, RefusesAFigureThatStandsStill) {
  Clip clip = walker_clip(walkers(), walkers().cycles[0], 3);
  for (int f = 1; f < clip.frames(); ++f) clip.values.col(f) = clip.values.col(0);
  const std::string file = own_file("still.bvh");
  write_file(file, bvh_text(clip));
  EXPECT_THROW(build_set({{file, "still.bvh", "still"}}, {}), InputError);
}

TEST(BuildSet, BringsFiguresOfOtherSizesToOneSkeleton) {
  const BuiltSet built = build_set({recorded(0), recorded(1, 0.8), recorded(2, 1.1)}, in_metres());
  ASSERT_EQ(built.set.size(), 3);
  const double leg = leg_length(walkers().skeleton, walkers().body);
  EXPECT_NEAR(leg_length(built.set.skeleton, built.set.body), leg * 2.9 / 3, 1e-3);
  for (const Cycle& cycle : built.set.cycles) {
    const double size = cycle.style == "normal" ? 1 : cycle.style == "happy" ? 0.8 : 1.1;
    EXPECT_NEAR(cycle.origin.scale, 2.9 / 3 / size, 1e-3) << cycle.name;
    // All walk at 1.3 m/s as they were made; feet that are planted may change 4 %.
    EXPECT_NEAR(cycle.velocity.y(), 1.3 * 2.9 / 3, 0.06) << cycle.name;
    EXPECT_LT(slide(built.set, cycle), 0.008) << cycle.name;
    EXPECT_LT(penetration_m(built.set, cycle), 0.003) << cycle.name;
  }
}

TEST(BuildSet, TakesTheBonesOfTheTakeThatIsNamed) {
  SetOptions options = in_metres();
  options.skeleton = "happy.bvh";
  const BuiltSet built = build_set({recorded(0), recorded(1, 0.8)}, options);
  const double leg = leg_length(walkers().skeleton, walkers().body);
  EXPECT_NEAR(leg_length(built.set.skeleton, built.set.body), 0.8 * leg, 1e-3);
}

TEST(BuildSet, StandsAllTakesOnOneFloor) {
  const std::string file = own_file("high.bvh");
  Clip clip = walker_clip(walkers(), walkers().cycles[0], 4);
  clip.values.row(1).array() += 0.3;
  write_file(file, bvh_text(clip));
  const BuiltSet built =
      build_set({recorded(0), recorded(2), {file, "z.bvh", "high"}}, in_metres());
  ASSERT_EQ(built.set.size(), 3);
  const double level = toe_level(built.set, built.set.cycles[0]);
  EXPECT_GT(level, 0.01);
  EXPECT_LT(level, 0.06);
  for (const Cycle& cycle : built.set.cycles) {
    EXPECT_NEAR(toe_level(built.set, cycle), level, 0.002) << cycle.name;
  }
}

TEST(BuildSet, UsesOnlyTheFramesThatAreAskedFor) {
  TakeSource source = recorded(0, 1, 6);
  const int frames = cycle_clip(walkers(), walkers().cycles[0]).frames() - 1;
  source.from = 2 * frames;
  source.to = 5 * frames;
  const BuiltSet built = build_set({source}, in_metres());
  ASSERT_EQ(built.set.size(), 1);
  EXPECT_GE(built.set.cycles[0].first_frame, *source.from);
  EXPECT_LE(built.set.cycles[0].first_frame + frames, *source.to);
  EXPECT_LE(built.set.cycles[0].origin.cycles_found, 2);
}

// A figure that squats: three keytimes, no steps.
std::string squats() {
  Clip clip = walker_clip(walkers(), walkers().cycles[0], 1);
  const Eigen::VectorXd first = clip.values.col(0);
  clip.values.resize(first.size(), 121);
  for (int f = 0; f <= 120; ++f) {
    clip.values.col(f) = first;
    clip.values(1, f) -= 0.2 * (1 - std::cos(2 * M_PI * f / 40.0));
  }
  const std::string file = own_file("squat.bvh");
  write_file(file, bvh_text(clip));
  return file;
}

TEST(BuildSet, TakesAnyCycleThatIsGiven) {
  SetOptions options = in_metres();
  options.walk = false;
  options.key_phases = {0, 0.5, 1};
  TakeSource source{squats(), "squat.bvh", "squat"};
  source.cycles = {{"deep", {40, 60, 80}}, {"", {0, 18, 40}}};
  const BuiltSet built = build_set({source}, options);
  ASSERT_EQ(built.set.size(), 2);
  EXPECT_FALSE(built.set.walk);
  const Cycle& deep = built.set.cycles[0];
  EXPECT_EQ(deep.name, "deep");
  EXPECT_EQ(built.set.cycles[1].name, "squat_1");
  EXPECT_EQ(deep.first_frame, 40);
  EXPECT_EQ(deep.frames, 40);
  EXPECT_NEAR(deep.keytimes[1], 0.5 * deep.seconds, 1e-9);
  EXPECT_LT(deep.loop_error_m, 1e-6);
  EXPECT_NEAR(deep.root.row(1).maxCoeff() - deep.root.row(1).minCoeff(), 0.4, 0.002);
  EXPECT_EQ(to_bytes(from_bytes(to_bytes(built.set), "x.set")), to_bytes(built.set));
}

TEST(BuildSet, FindsTheLoopOfAnyMotionWhereItIsLikeItself) {
  SetOptions options = in_metres();
  options.walk = false;
  options.key_phases = {0, 1};
  const BuiltSet built = build_set({{squats(), "squat.bvh", "squat"}}, options);
  ASSERT_EQ(built.set.size(), 1);
  const Cycle& cycle = built.set.cycles[0];
  EXPECT_EQ(cycle.frames, 40);  // once around, though twice is a loop as well
  EXPECT_LT(cycle.loop_error_m, 1e-6);
  EXPECT_GT(cycle.origin.cycles_found, 1);
}

TEST(BuildSet, SaysThatAMotionNeverComesBack) {
  Clip clip = walker_clip(walkers(), walkers().cycles[0], 1);
  clip.values.conservativeResize(Eigen::NoChange, 60);
  for (int f = 0; f < 60; ++f) clip.values(1, f) -= 0.01 * f;  // sinks and sinks
  const std::string file = own_file("sinks.bvh");
  write_file(file, bvh_text(clip));
  SetOptions options = in_metres();
  options.walk = false;
  options.key_phases = {0, 1};
  EXPECT_THROW(build_set({{file, "sinks.bvh", "sinks"}}, options), InputError);
}

TEST(BuildSet, NamesEveryGivenCycleThatCannotBe) {
  TakeSource source = recorded(0);
  source.cycles = {{"a", {0, 1, 2, 3, 9999}, {7, 1}}, {"b", {-5, 1, 2, 3, 4}, {9, 1}}};
  SetOptions options = in_metres();
  options.recipe = "r.toml";
  try {
    build_set({source}, options);
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 2U);
    EXPECT_EQ(error.problems()[0].file, "r.toml");
    EXPECT_EQ(error.problems()[0].line, 7);
    EXPECT_EQ(error.problems()[1].line, 9);
    EXPECT_EQ(error.problems()[1].message.rfind("normal.bvh has frames 0 to ", 0), 0U);
  }
}

TEST(BuildSet, KeepsWhereEachCycleComesFrom) {
  TakeSource source = recorded(0);
  source.sha256 = std::string(64, 'a');
  const BuiltSet built = build_set({source}, in_metres());
  const MotionSet back = from_bytes(to_bytes(built.set), "x.set");
  const CycleOrigin& origin = back.cycles[0].origin;
  EXPECT_EQ(origin.sha256, source.sha256);
  EXPECT_NEAR(origin.frame_time, walkers().cycles[0].seconds / back.cycles[0].frames, 1e-3);
  EXPECT_EQ(origin.cycles_found, 2);
  EXPECT_GT(origin.straightness, 0.98);
  EXPECT_NEAR(origin.moved_m, built.reports[0].from_capture_m, 0);
}

TEST(BuildSet, DoesNotDependOnTheOrderOfTakesOfManySizes) {
  std::vector<TakeSource> sources = {recorded(3), recorded(0, 0.9), recorded(1, 1.1)};
  const std::string bytes = to_bytes(build_set(sources, in_metres()).set);
  std::rotate(sources.begin(), sources.begin() + 1, sources.end());
  EXPECT_EQ(to_bytes(build_set(sources, in_metres()).set), bytes);
}

}  // namespace
}  // namespace promenade::motion
