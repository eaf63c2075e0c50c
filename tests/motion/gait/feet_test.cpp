#include "motion/gait/feet.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::motion::gait {
namespace {

using Eigen::Vector3d;

TEST(FootPose, StandsStillWhileTheSoleIsFlat) {
  const GaitStyle style;
  const FootPose first = foot_pose(style, Side::right, style.timing.foot_flat + 1e-9);
  const FootPose last = foot_pose(style, Side::right, style.timing.heel_off - 1e-9);
  EXPECT_NEAR((first.ankle - last.ankle).norm(), 0, 1e-12);
  EXPECT_NEAR(first.ankle.y(), ankle_height, 1e-12);
}

TEST(FootPose, TurnsAboutTheHeelAfterItsStrike) {
  const GaitStyle style;
  const FootPose strike = foot_pose(style, Side::left, style.timing.left_strike);
  const FootPose later = foot_pose(style, Side::left, style.timing.left_strike + 0.04);
  const Vector3d heel = strike.ankle + strike.turn * heel_point;
  EXPECT_NEAR(heel.y(), 0, 1e-12);
  EXPECT_NEAR((later.ankle + later.turn * heel_point - heel).norm(), 0, 1e-12);
}

TEST(FootPose, TurnsAboutTheToeJointBeforeToeOff) {
  const GaitStyle style;
  const FootPose rising = foot_pose(style, Side::right, 0.45);
  const FootPose off = foot_pose(style, Side::right, style.timing.stance);
  EXPECT_NEAR(
      ((rising.ankle + rising.turn * toe_joint) - (off.ankle + off.turn * toe_joint)).norm(), 0,
      1e-12);
  EXPECT_GT(off.ankle.y(), rising.ankle.y() + 0.03);
}

// Position and velocity meet at both ends of the swing: over 1e-6 of a stride a
// velocity of 4 m/s moves 5e-6 m, and a step in it would be as large.
TEST(FootPose, SwingsWithoutAStepInPositionOrVelocity) {
  const GaitStyle style;
  constexpr double h = 1e-6;
  for (const double at : {style.timing.stance, 1.0}) {
    const Vector3d before = foot_pose(style, Side::right, at - h).ankle;
    const Vector3d now = foot_pose(style, Side::right, at).ankle;
    const Vector3d after = foot_pose(style, Side::right, at + h).ankle;
    EXPECT_LT((after - 2 * now + before).norm() / h, 1e-3);
  }
}

TEST(FootPose, MovesOnByAStrideEveryStride) {
  const GaitStyle style;
  for (const double stride : {0.2, 0.55, 0.8}) {
    const Vector3d moved =
        foot_pose(style, Side::left, stride + 3).ankle - foot_pose(style, Side::left, stride).ankle;
    EXPECT_NEAR((moved - Vector3d(0, 0, 3 * stride_length(style))).norm(), 0, 1e-9);
  }
}

}  // namespace
}  // namespace promenade::motion::gait
