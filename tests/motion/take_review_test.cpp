#include "motion/take_review.h"

#include <gtest/gtest.h>

#include "motion/bvh.h"
#include "motion/files.h"
#include "motion/shared_skeleton.h"
#include "tests/motion/walker.h"
#include "tests/test_folder.h"

namespace promenade::motion {
namespace {

const MotionSet& walkers() {
  static const MotionSet set = builtin_set("A").value();
  return set;
}

// A file of a walker in a folder of the test's own.
TakeSource written(const TestFolder& folder, const Clip& clip) {
  const std::string file = folder.file("take.bvh");
  write_file(file, bvh_text(clip));
  return {file, "take.bvh", "take"};
}

TEST(TakeReview, FindsTheLoopsOfAWalkAndThatItsUnitWasGuessed) {
  const TestFolder folder;
  const TakeSource source = written(folder, walker_clip(walkers(), walkers().cycles[0], 6));
  const TakeReview review = review_take(source, {});
  EXPECT_EQ(review.kind, TakeKind::walks);
  EXPECT_GE(review.search.candidates.size(), 4U);
  EXPECT_TRUE(review.unit_guessed);
  EXPECT_TRUE(review.gaps.empty());
  EXPECT_TRUE(review.stretches.turning.empty());
  TakeSource said = source;
  said.figure.unit_m = 1;
  EXPECT_FALSE(review_take(said, {}).unit_guessed);
}

TEST(TakeReview, SaysOfATakeThatTurnsThatItTurns) {
  const Take straight = walker_take(walkers(), walkers().cycles[0], 6);
  const double per_frame = 1.2 * straight.frame_time;  // radians: 1.2 in a second
  const Take bent = turned(straight, [&](int f) { return per_frame * f; });
  const TakeStretches found = find_stretches(bent);
  EXPECT_GT(frames_in(found.turning), bent.frames() * 8 / 10);
  EXPECT_TRUE(find_stretches(straight).turning.empty());
  EXPECT_TRUE(find_stretches(straight).jumps.empty());
}

TEST(TakeReview, SeesWhereATakeStands) {
  const Take walk = walker_take(walkers(), walkers().cycles[0], 3);
  const int still = static_cast<int>(2 / walk.frame_time);
  const TakeStretches found = find_stretches(standing_around(walk, still));
  ASSERT_EQ(found.standing.size(), 2U);
  EXPECT_EQ(found.standing[0].first, 0);
  // A quarter of a second to either side decides.
  EXPECT_NEAR(found.standing[0].last, still, 0.26 / walk.frame_time);
}

TEST(TakeReview, SeesAJump) {
  Take take = walker_take(walkers(), walkers().cycles[0], 3);
  take.poses[40].root.x() += 0.5;
  const TakeStretches found = find_stretches(take);
  ASSERT_EQ(found.jumps.size(), 1U);
  EXPECT_EQ(found.jumps[0].first, 39);
  EXPECT_EQ(found.jumps[0].last, 41);
}

TEST(TakeReview, GivesGapsInFramesOfTheTake) {
  Take take;
  take.first_frame = 10;
  take.poses.resize(20);
  const std::vector<FrameRange> gaps =
      gaps_within(take, {{-1, {12, 15}}, {3, {14, 18}}, {4, {2, 5}}, {5, {28, 40}}});
  ASSERT_EQ(gaps.size(), 2U);
  EXPECT_EQ(gaps[0].first, 2);
  EXPECT_EQ(gaps[0].last, 8);
  EXPECT_EQ(gaps[1].first, 18);
  EXPECT_EQ(gaps[1].last, 19);
}

// One take has the skeleton of the set to itself, so that nothing is scaled.
TEST(TakeReview, CutsALoopAsTheSetDoes) {
  const TestFolder folder;
  TakeSource source = written(folder, walker_clip(walkers(), walkers().cycles[1], 5));
  const BuiltSet built = build_set({source}, {});
  const TakeReview review = review_take(source, {});
  const LoopReview loop = review_loop(review.take, review.search.candidates.front().keys, {});
  const Cycle& same = built.set.cycles.front();
  EXPECT_EQ(loop.cycle().first_frame, same.first_frame);
  EXPECT_EQ(loop.cycle().rotations, same.rotations);
  EXPECT_EQ(loop.cycle().root, same.root);
  EXPECT_EQ(loop.seam_m, same.loop_error_m);
  EXPECT_EQ(loop.slide_m, std::max(built.reports[0].slide_left_m, built.reports[0].slide_right_m));
}

TEST(TakeReview, MovesAnEndNoFurtherThanTheKeytimeBesideIt) {
  const Take take = walker_take(walkers(), walkers().cycles[0], 3);
  const std::vector<double> keys = {10, 20, 24, 34, 40};
  EXPECT_EQ(with_end_at(take, keys, false, 12).front(), 12);
  EXPECT_EQ(with_end_at(take, keys, false, 30).front(), 19);
  EXPECT_EQ(with_end_at(take, keys, false, -5).front(), 0);
  EXPECT_EQ(with_end_at(take, keys, true, 20).back(), 35);
  EXPECT_EQ(with_end_at(take, keys, true, 1e9).back(), take.frames() - 1);
}

TEST(TakeReview, OfACycleBeyondTheEndOfALoopRunsOverItsSeam) {
  const TestFolder folder;
  TakeSource source = written(folder, walker_clip(walkers(), walkers().cycles[0], 1));
  const TakeReview review = review_take(source, {});
  ASSERT_GT(review.take.period, 0);
  std::vector<double> keys = review.search.candidates.front().keys;
  source.cycles = {{"over", keys}};
  ASSERT_GT(keys.back(), review.take.period);
  EXPECT_EQ(build_set({source}, {}).set.cycles.front().name, "over");
}

}  // namespace
}  // namespace promenade::motion
