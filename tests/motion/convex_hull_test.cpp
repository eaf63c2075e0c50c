#include "motion/convex_hull.h"

#include <gtest/gtest.h>

namespace promenade::motion {
namespace {

TEST(ConvexHull, HasTheCornersOnly) {
  Eigen::Matrix2Xd points(2, 6);
  points << 0, 2, 2, 0, 1, 1,  //
      0, 0, 2, 2, 1, 0;        // the last one lies on an edge
  EXPECT_EQ(convex_hull(points, {5, 4, 3, 2, 1, 0}), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(convex_hull(points, {4, 2}), (std::vector<int>{4, 2}));
  EXPECT_EQ(convex_hull(points, {4}), std::vector<int>{4});
}

}  // namespace
}  // namespace promenade::motion
