#include "motion/gait/traits.h"

#include <gtest/gtest.h>

namespace promenade::motion::gait {
namespace {

TEST(Traits, AddUp) {
  GaitStyle once, twice;
  crouched(once, 0.75);
  crouched(twice, 0.5);
  crouched(twice, 0.25);
  EXPECT_DOUBLE_EQ(once.knees.mid, twice.knees.mid);
  EXPECT_DOUBLE_EQ(once.trunk.lean, twice.trunk.lean);
  EXPECT_DOUBLE_EQ(once.character.openness, twice.character.openness);
}

TEST(Traits, ChangeWhatTheStyleMeansAlongWithIt) {
  GaitStyle style;
  swaying(style, 1);
  EXPECT_LT(style.character.steadiness, 0);
  EXPECT_GT(style.trunk.sway, GaitStyle{}.trunk.sway);
}

TEST(Traits, HoldTheArmsStill) {
  GaitStyle style;
  still_arms(style, 1);
  EXPECT_EQ(style.arms.swing, 0);
  EXPECT_EQ(style.arms.elbow_swing, 0);
}

TEST(Traits, SlowWhenFastIsNegative) {
  GaitStyle style;
  fast(style, -1);
  EXPECT_LT(style.timing.speed, GaitStyle{}.timing.speed);
  EXPECT_LT(style.character.pace, 0);
}

}  // namespace
}  // namespace promenade::motion::gait
