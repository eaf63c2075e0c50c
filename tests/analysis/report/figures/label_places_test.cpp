#include "analysis/report/figures/label_places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/report/figures/style.h"

namespace promenade::analysis {
namespace {

constexpr double points = 6;
constexpr double height = points * 25.4 / 72;

TEST(LabelPlaces, AreOnTheRightWhereThereIsRoom) {
  const auto places = label_places({{10, 10, "a"}, {39, 10, "far right"}}, 40, 20, points);
  ASSERT_TRUE(places[0] && places[1]);
  EXPECT_GT(places[0]->left_mm, 10);
  EXPECT_DOUBLE_EQ(places[0]->middle_mm, 10);
  EXPECT_LT(places[1]->left_mm, 39);
}

TEST(LabelPlaces, NeverOverlapAndStayInside) {
  std::vector<Dot> dots;
  for (int i = 0; i < 55; ++i) {
    dots.push_back({i * 17 % 56 * 1.0, i * 23 % 50 * 1.0, i % 3 == 0 ? "歩き方" : "walk"});
  }
  const auto places = label_places(dots, 56, 50, points);
  int named = 0;
  for (std::size_t i = 0; i < dots.size(); ++i) {
    if (!places[i]) continue;
    ++named;
    const double width = text_mm(dots[i].name) * points / 8;
    EXPECT_GE(places[i]->left_mm, 0);
    EXPECT_LE(places[i]->left_mm + width, 56);
    for (std::size_t j = 0; j < i; ++j) {
      if (!places[j]) continue;
      const double other = text_mm(dots[j].name) * points / 8;
      const bool apart = places[i]->left_mm >= places[j]->left_mm + other ||
                         places[j]->left_mm >= places[i]->left_mm + width ||
                         std::abs(places[i]->middle_mm - places[j]->middle_mm) >= height - 1e-9;
      EXPECT_TRUE(apart) << i << " and " << j;
    }
  }
  EXPECT_GT(named, 30);
}

TEST(LabelPlaces, OfWhatHasNoRoomAreNothing) {
  EXPECT_FALSE(label_places({{1, 1, "a name that is long"}}, 5, 5, points)[0]);
  EXPECT_TRUE(label_places({}, 5, 5, points).empty());
}

}  // namespace
}  // namespace promenade::analysis
