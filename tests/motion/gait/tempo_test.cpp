#include "motion/gait/tempo.h"

#include <gtest/gtest.h>

namespace promenade::motion::gait {
namespace {

TEST(AtTempo, LeavesAWalkAtItsOwnSpeedAsItIs) {
  const GaitStyle style;
  const GaitStyle same = at_tempo(style, 1);
  EXPECT_EQ(same.timing.cadence, style.timing.cadence);
  EXPECT_EQ(same.timing.stance, style.timing.stance);
  EXPECT_EQ(same.arms.swing, style.arms.swing);
  EXPECT_EQ(same.trunk.lean, style.trunk.lean);
}

TEST(AtTempo, SharesTheSpeedBetweenCadenceAndStepLength) {
  const GaitStyle style;
  const GaitStyle fast = at_tempo(style, 1.4);
  EXPECT_NEAR(fast.timing.speed, 1.4 * style.timing.speed, 1e-12);
  const double cadence = fast.timing.cadence / style.timing.cadence;
  const double step = stride_length(fast) / stride_length(style);
  EXPECT_NEAR(cadence * step, 1.4, 1e-12);
  EXPECT_NEAR(cadence, step, 0.06);  // people keep the ratio of the two
}

TEST(AtTempo, ChangesBothArmsAlike) {
  GaitStyle style;
  style.left_arm = style.arms;
  const GaitStyle slow = at_tempo(style, 0.7);
  EXPECT_LT(slow.arms.swing, style.arms.swing);
  EXPECT_EQ(slow.arms.swing, slow.left_arm->swing);
}

TEST(AtTempo, SaysHowFastItIs) {
  EXPECT_LT(at_tempo({}, 0.7).character.pace, 0);
  EXPECT_EQ(at_tempo({}, 3).character.pace, 1);
}

}  // namespace
}  // namespace promenade::motion::gait
