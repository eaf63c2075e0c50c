#include "motion/graph/seam_measures.h"

#include <gtest/gtest.h>

#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

// Five times the same pose.
Take still() {
  const MotionSet set = builtin_set("A").value();
  Take take = part(walker_take(set, set.cycles[0], 1), 10, 10);
  take.poses.resize(5, take.poses[0]);
  return take;
}

Eigen::Quaterniond& rotation_of(Take& take, std::size_t frame, BodyJoint joint) {
  return take.poses[frame].rotations[static_cast<std::size_t>(take.body.joint[joint])];
}

TEST(FrameGaps, OfAFigureThatStandsStillAreNone) {
  const Take take = still();
  const FrameGap gap = largest_gap(frame_gaps(take, knee_axes(take)));
  EXPECT_EQ(gap.place_m, 0);
  EXPECT_EQ(gap.knee, 0);
}

TEST(FrameGaps, OfAJumpAreItsLength) {
  Take take = still();
  for (std::size_t f = 2; f < 5; ++f) take.poses[f].root.x() += 0.03;
  const std::vector<FrameGap> gaps = frame_gaps(take, knee_axes(take));
  ASSERT_EQ(gaps.size(), 5U);
  EXPECT_NEAR(gaps[1].place_m, 0.03, 1e-12);
  EXPECT_NEAR(gaps[2].place_m, 0.03, 1e-12);
  EXPECT_EQ(gaps[0].place_m, 0);
  EXPECT_EQ(gaps[3].place_m, 0);
  EXPECT_LT(largest_gap(gaps).knee, 1e-12) << "a jump of the whole body bends no knee";
}

TEST(FrameGaps, OfASpeedAreNoneAndOfItsChangeAreTheChange) {
  Take take = still();
  const double way[] = {0, 0.01, 0.02, 0.02, 0.02};
  for (std::size_t f = 0; f < 5; ++f) take.poses[f].root.z() += way[f];
  const std::vector<FrameGap> gaps = frame_gaps(take, knee_axes(take));
  EXPECT_LT(gaps[1].place_m, 1e-12);
  EXPECT_NEAR(gaps[2].place_m, 0.01, 1e-12);
}

TEST(FrameGaps, OfAKneeAreInItsBend) {
  Take take = still();
  const KneeAxes axes = knee_axes(take);
  rotation_of(take, 2, right_knee) =
      Eigen::AngleAxisd(0.2, axes[1]) * rotation_of(take, 2, right_knee);
  const std::vector<FrameGap> gaps = frame_gaps(take, axes);
  EXPECT_NEAR(gaps[1].knee, 0.2, 1e-9);
  EXPECT_NEAR(gaps[2].knee, 0.4, 1e-9);
}

}  // namespace
}  // namespace promenade::motion
