#include "motion/gait/pelvis.h"

#include <gtest/gtest.h>

namespace promenade::motion::gait {
namespace {

TEST(PelvisHeight, IsLowInDoubleSupportAndHighOverTheStanceLeg) {
  const PelvisHeight height = pelvis_height(GaitStyle{});
  EXPECT_LT(height_at(height, 0.03) + 0.03, height_at(height, 0.27));
  EXPECT_NEAR(height_at(height, 0.03), height_at(height, 0.53), 1e-6);
}

TEST(PelvisHeight, SinksWhenTheKneesShouldBend) {
  GaitStyle crouching;
  crouching.knees = {40, 40, 40, 40, 60, 0};
  EXPECT_LT(height_at(pelvis_height(crouching), 0.3),
            height_at(pelvis_height(GaitStyle{}), 0.3) - 0.03);
}

TEST(PelvisPath, GoesOverTheStanceLegAndOnByAStride) {
  const GaitStyle style;
  EXPECT_LT(pelvis_path(style, 0.3).x(), 0);  // right foot down
  EXPECT_GT(pelvis_path(style, 0.8).x(), 0);  // left foot down
  const double ahead = pelvis_path(style, 1.4).z() - pelvis_path(style, 0.4).z();
  EXPECT_NEAR(ahead, stride_length(style), 1e-12);
}

TEST(PelvisTurn, BringsTheStrikingHipForward) {
  const GaitStyle style;
  EXPECT_GT(hip_offset(style, Side::right, 0).z(), hip_offset(style, Side::left, 0).z());
  EXPECT_LT(hip_offset(style, Side::left, 0.2).y(), hip_offset(style, Side::right, 0.2).y());
}

}  // namespace
}  // namespace promenade::motion::gait
