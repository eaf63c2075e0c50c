#include "motion/heel.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

const Vector3d flat_ankle(0.1, 0.09, 0.3), flat_toe(0.14, 0.02, 0.45);

TEST(Heel, IsBehindTheAnkleAtTheHeightOfTheToeWhenTheFootIsFlat) {
  const Heel heel = find_heel(flat_ankle, flat_toe);
  const Vector3d at = heel_position(heel, flat_ankle, flat_toe);
  EXPECT_LT((at - Vector3d(0.09, 0.02, 0.2625)).norm(), 1e-12);
}

TEST(Heel, IsOnTheGroundWhereThatIsAskedFor) {
  const Heel heel = find_heel(flat_ankle, flat_toe, 0);
  const Vector3d at = heel_position(heel, flat_ankle, flat_toe);
  EXPECT_LT((at - Vector3d(0.09, 0, 0.2625)).norm(), 1e-12);
}

TEST(Heel, StaysWhereItIsWhileTheFootTurnsAboutIt) {
  const Heel heel = find_heel(flat_ankle, flat_toe);
  const Vector3d centre = heel_position(heel, flat_ankle, flat_toe);
  const Vector3d across = (flat_toe - flat_ankle).cross(Vector3d::UnitY()).normalized();
  for (const double degrees : {-20.0, 10.0, 35.0}) {
    const Eigen::AngleAxisd pitch(degrees * M_PI / 180, across);
    const Vector3d ankle = centre + pitch * (flat_ankle - centre);
    const Vector3d toe = centre + pitch * (flat_toe - centre);
    EXPECT_LT((heel_position(heel, ankle, toe) - centre).norm(), 1e-12) << degrees;
  }
}

TEST(Heel, GoesWithAFootThatTurnsAboutTheVertical) {
  const Heel heel = find_heel(flat_ankle, flat_toe);
  const Eigen::AngleAxisd yaw(2, Vector3d::UnitY());
  const Vector3d turned = heel_position(heel, yaw * flat_ankle, yaw * flat_toe);
  EXPECT_LT((turned - yaw * heel_position(heel, flat_ankle, flat_toe)).norm(), 1e-12);
}

}  // namespace
}  // namespace promenade::motion
