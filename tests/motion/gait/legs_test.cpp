#include "motion/gait/legs.h"

#include <gtest/gtest.h>

#include "motion/gait/figure.h"

namespace promenade::motion::gait {
namespace {

using Eigen::Vector3d;

TEST(LegTurns, PutTheAnkleWhereItIsWanted) {
  const Vector3d hip(0.1, 0.9, 0.05);
  for (const Vector3d& ankle : {Vector3d(0.05, 0.1, 0.3), Vector3d(0.1, 0.3, -0.4)}) {
    const LegTurns leg = leg_turns(hip, ankle, Vector3d::UnitZ());
    const Vector3d reached =
        hip + leg.thigh * Vector3d(0, -thigh_length, 0) + leg.shank * Vector3d(0, -shank_length, 0);
    EXPECT_NEAR((reached - ankle).norm(), 0, 1e-12);
  }
}

TEST(LegTurns, BendTheKneeForward) {
  const Vector3d hip(0, 0.9, 0);
  const Vector3d ankle(0, 0.2, 0);
  const LegTurns leg = leg_turns(hip, ankle, Vector3d::UnitZ());
  const Vector3d knee = hip + leg.thigh * Vector3d(0, -thigh_length, 0);
  EXPECT_GT(knee.z(), 0.2);
  EXPECT_NEAR(knee.x(), 0, 1e-12);
}

}  // namespace
}  // namespace promenade::motion::gait
