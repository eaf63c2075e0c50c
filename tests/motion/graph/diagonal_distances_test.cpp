#include "motion/graph/diagonal_distances.h"

#include <gtest/gtest.h>

#include "motion/graph/window_distance.h"
#include "tests/motion/graph/random_clouds.h"

namespace promenade::motion {
namespace {

// Pairs in an order that runs along diagonals both ways, and jumps.
const std::vector<std::pair<int, int>> pairs = {{20, 30}, {21, 31}, {22, 32}, {21, 31}, {20, 30},
                                                {20, 31}, {3, 13},  {50, 2},  {21, 31}, {19, 29}};

TEST(DiagonalDistances, AreThoseOfTheClosedForm) {
  const Clouds a = random_clouds(1, 80, 6, 1000), b{random_clouds(2, 70, 6).points, a.weights};
  for (const auto& taper : {even_taper(12), uneven_taper(12)}) {
    const MapSide first = map_side(a, taper), second = map_side(b, taper);
    DiagonalDistances distances(first, second, {0, 0, 69, 59});
    for (const auto& [r, c] : pairs) {
      const WindowDistance truth = window_distance(a, r, b, c + 11, taper);
      // Squares of a few metres, and of the thousand that the middle was taken from.
      EXPECT_NEAR(distances.mean_square(r, c), truth.sum / truth.weight, 1e-12) << r << " " << c;
    }
  }
}

TEST(DiagonalDistances, OfACopyAreZero) {
  const Clouds a = random_clouds(3, 60, 6), b = moved({2, 5, -5}, a);
  const MapSide first = map_side(a, even_taper(8)), second = map_side(b, even_taper(8));
  DiagonalDistances distances(first, second, {0, 0, 53, 53});
  for (int r = 0; r < 53; ++r) EXPECT_LT(distances.mean_square(r, r), 1e-13);
}

}  // namespace
}  // namespace promenade::motion
