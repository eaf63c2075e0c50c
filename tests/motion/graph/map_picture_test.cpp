#include "motion/graph/map_picture.h"

#include <gtest/gtest.h>

#include "motion/graph/window_distance.h"
#include "tests/motion/graph/random_clouds.h"

namespace promenade::motion {
namespace {

// The smallest distance of window pairs of two stretches of windows, by the closed form.
double least(const Clouds& a, int from_a, int to_a, const Clouds& b, int from_b, int to_b,
             const std::vector<double>& taper) {
  double smallest = 1e300;
  for (int r = from_a; r < to_a; ++r) {
    for (int c = from_b; c < to_b; ++c) {
      const int j = c + static_cast<int>(taper.size()) - 1;
      smallest = std::min(smallest, window_distance(a, r, b, j, taper).rms());
    }
  }
  return smallest;
}

TEST(MapPicture, ShowsTheSmallestOfEachCell) {
  const Clouds a = random_clouds(1, 44, 3), b{random_clouds(2, 64, 3).points, a.weights};
  const std::vector<double> taper = even_taper(5);  // 40 and 60 windows
  const MapPicture picture = map_picture({&a}, {&b}, taper, 8, 10);
  ASSERT_EQ(picture.rms.rows(), 8);
  ASSERT_EQ(picture.rms.cols(), 10);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 10; ++x) {
      EXPECT_NEAR(picture.rms(y, x), least(a, 5 * y, 5 * y + 5, b, 6 * x, 6 * x + 6, taper), 1e-5);
    }
  }
}

TEST(MapPicture, LaysTakesEndToEnd) {
  const Clouds a = random_clouds(3, 24, 3), b{random_clouds(4, 14, 3).points, a.weights};
  const std::vector<const Clouds*> takes = {&a, &b};
  const std::vector<double> taper = even_taper(5);  // 20 and 10 windows
  const MapPicture picture = map_picture(takes, takes, taper, 6, 6);
  EXPECT_EQ(picture.starts_down, (std::vector<int>{0, 20, 30}));
  EXPECT_NEAR(picture.rms(1, 5), least(a, 5, 10, b, 5, 10, taper), 1e-5);
  EXPECT_NEAR(picture.rms(5, 4), least(b, 5, 10, b, 0, 5, taper), 1e-5);
  EXPECT_TRUE(picture.rms == picture.rms.transpose());
}

TEST(MapPicture, IsNoLargerThanTheMap) {
  const Clouds a = random_clouds(5, 7, 3);
  EXPECT_EQ(map_picture({&a}, {&a}, even_taper(5), 100, 200).rms.rows(), 3);
  EXPECT_EQ(map_picture({&a}, {&a}, even_taper(8), 100, 200).rms.size(), 0);
  EXPECT_EQ(map_picture({}, {}, even_taper(8), 100, 200).rms.size(), 0);
}

}  // namespace
}  // namespace promenade::motion
