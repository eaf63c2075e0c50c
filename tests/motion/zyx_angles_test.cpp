#include "motion/zyx_angles.h"

#include <gtest/gtest.h>

namespace promenade::motion {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d product(const Vector3d& degrees) {
  const Vector3d a = degrees * (M_PI / 180);
  return (Eigen::AngleAxisd(a(0), Vector3d::UnitZ()) * Eigen::AngleAxisd(a(1), Vector3d::UnitY()) *
          Eigen::AngleAxisd(a(2), Vector3d::UnitX()))
      .toRotationMatrix();
}

TEST(ZyxAngles, GiveTheRotationBackAlsoNear90DegreesAboutY) {
  for (const double y : {-90.0, -89.9999999, -30.0, 0.0, 45.0, 89.9999999, 90.0}) {
    const Matrix3d rotation = product({20, y, -130});
    EXPECT_LT((product(zyx_angles(rotation)) - rotation).cwiseAbs().maxCoeff(), 1e-14) << y;
  }
}

TEST(ZyxAngles, RunOnFromTheAnglesBefore) {
  const Vector3d before(359, 100, -721), now(361, 101, -719);
  EXPECT_LT((zyx_angles(product(now), before) - now).norm(), 1e-9);
}

}  // namespace
}  // namespace promenade::motion
