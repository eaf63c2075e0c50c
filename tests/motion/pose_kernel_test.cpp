#include "motion/pose_kernel.h"

#include <gtest/gtest.h>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Turns of about `turn` radians of 24 lanes in 11 cycles, mixed by weights of any sign.
MatrixXd blended(double turn, bool wide) {
  constexpr int lanes = 24, rows = 80, cycles = 11;
  Random random(1);
  const VectorXd weights = random.normals(cycles, 1);
  const MatrixXd offsets = turn / weights.norm() * random.normals(rows * cycles, 1);
  const MatrixXd average = random.normals(lanes, 4).rowwise().normalized();
  MatrixXd result(lanes, 4);
  VectorXd mixed(rows);
  blend_rotations({lanes, rows, cycles, weights.data(), offsets.data(), average.data()},
                  mixed.data(), result.data(), wide);
  return result;
}

// One size of turn for each of the series, and one that none reaches.
TEST(ThePoseKernel, HasTheSameDigitsOnEveryProcessor) {
  if (!has_wide()) GTEST_SKIP() << "this processor has no AVX2: there is one way here";
  for (const double turn : {0.01, 0.1, 0.3, 0.8, 3.0}) {
    EXPECT_EQ(blended(turn, true), blended(turn, false)) << "turns of about " << turn;
  }
}

TEST(ThePoseKernel, GivesUnitQuaternions) {
  for (const double turn : {0.01, 0.1, 0.3, 0.8, 3.0}) {
    const VectorXd lengths = blended(turn, false).rowwise().norm();
    EXPECT_LE((lengths.array() - 1).abs().maxCoeff(), 1e-14) << "turns of about " << turn;
  }
}

}  // namespace
}  // namespace promenade::motion
