#include "analysis/pictures/map_layout.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

TEST(Labels, DoNotCoverEachOtherWhereThereIsRoom) {
  Eigen::Matrix2Xd dots(2, 3);
  dots << 0, 20, 10,  //
      0, 0, 15;
  const std::vector<double> widths = {60, 60, 60};
  const auto spots = place_labels(dots, widths, 12, 4, {{-200, -200}, {200, 200}});
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Eigen::Vector2d apart = (spots[i].at - spots[j].at).cwiseAbs();
      EXPECT_TRUE(apart.x() >= 60 || apart.y() >= 12) << i << " " << j;
    }
  }
}

TEST(Labels, StayInTheRoomWhenTheyCan) {
  const Eigen::Matrix2Xd dots = Eigen::Vector2d(95, 50);
  const auto spots = place_labels(dots, {40}, 12, 4, {{0, 0}, {100, 100}});
  EXPECT_LE(spots[0].at.x() + 20, 100);
}

}  // namespace
}  // namespace promenade::analysis
