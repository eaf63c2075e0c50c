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

TEST(LabelsWithRoom, AreOnTheRightWhereTheyCan) {
  Eigen::Matrix2Xd dots(2, 2);
  dots << 10, 39,  //
      10, 10;
  const auto spots = place_labels_with_room(dots, {2, 8}, 2, 0.5, {{0, 0}, {40, 20}});
  ASSERT_TRUE(spots[0] && spots[1]);
  EXPECT_GT(spots[0]->at.x(), 10);
  EXPECT_DOUBLE_EQ(spots[0]->at.y(), 10);
  EXPECT_LT(spots[1]->at.x(), 39);
}

TEST(LabelsWithRoom, NeverOverlapAndStayInside) {
  constexpr int count = 55;
  constexpr double height = 2;
  Eigen::Matrix2Xd dots(2, count);
  std::vector<double> widths;
  for (int i = 0; i < count; ++i) {
    dots.col(i) << i * 17 % 56, i * 23 % 50;
    widths.push_back(i % 3 == 0 ? 6 : 4);
  }
  const auto spots = place_labels_with_room(dots, widths, height, 0.5, {{0, 0}, {56, 50}});
  int named = 0;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (!spots[i]) continue;
    ++named;
    EXPECT_GE(spots[i]->at.x() - widths[i] / 2, -1e-6);
    EXPECT_LE(spots[i]->at.x() + widths[i] / 2, 56 + 1e-6);
    for (std::size_t j = 0; j < i; ++j) {
      if (!spots[j]) continue;
      const Eigen::Vector2d apart = (spots[i]->at - spots[j]->at).cwiseAbs();
      const double aside = (widths[i] + widths[j]) / 2 - 1e-6;
      EXPECT_TRUE(apart.x() >= aside || apart.y() >= height - 1e-6) << i << " and " << j;
    }
  }
  EXPECT_GT(named, 30);
}

TEST(LabelsWithRoom, AreNothingWhereThereIsNone) {
  const Eigen::Matrix2Xd dots = Eigen::Vector2d(1, 1);
  EXPECT_FALSE(place_labels_with_room(dots, {20}, 2, 0.5, {{0, 0}, {5, 5}})[0]);
  EXPECT_TRUE(place_labels_with_room(Eigen::Matrix2Xd(2, 0), {}, 2, 0.5, {{0, 0}, {5, 5}}).empty());
}

}  // namespace
}  // namespace promenade::analysis
