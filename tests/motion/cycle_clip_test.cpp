#include "motion/cycle_clip.h"

#include <gtest/gtest.h>

#include "motion/builtin.h"

namespace promenade::motion {
namespace {

TEST(RepeatedClip, GoesOnWhereTheCycleClosed) {
  const MotionSet set = builtin_set("A").value();
  const Clip one = cycle_clip(set, set.cycles[3]);
  const Eigen::Index frames = one.values.cols() - 1;
  EXPECT_EQ(repeated_clip(one, 1).values, one.values);
  const Clip three = repeated_clip(one, 3);
  ASSERT_EQ(three.values.cols(), 3 * frames + 1);
  const Eigen::Vector3d travel = one.values.col(frames).head<3>() - one.values.col(0).head<3>();
  EXPECT_GT(travel.z(), 0.5) << "metres that a walk gets on in a cycle";
  for (Eigen::Index f = 0; f < three.values.cols(); ++f) {
    const auto expected = one.values.col(f % frames);
    const double cycles = static_cast<double>(f / frames);
    EXPECT_TRUE(
        three.values.col(f).head<3>().isApprox(expected.head<3>() + cycles * travel, 1e-12));
    EXPECT_EQ(three.values.col(f).tail(3), expected.tail(3));
  }
}

}  // namespace
}  // namespace promenade::motion
