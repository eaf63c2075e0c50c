#include "motion/graph/distance_map.h"

#include <gtest/gtest.h>

#include <limits>
#include <mutex>

#include "motion/graph/window_distance.h"
#include "tests/motion/graph/random_clouds.h"

namespace promenade::motion {
namespace {

double mean_square(const Clouds& a, int r, const Clouds& b, int c,
                   const std::vector<double>& taper) {
  const int window = static_cast<int>(taper.size());
  const WindowDistance distance = window_distance(a, r, b, c + window - 1, taper);
  return distance.sum / distance.weight;
}

// The worst difference of a tile from the closed form in double, as a share of what the tile
// itself says that it may be.
double worst_error(const Clouds& a, const Clouds& b, const std::vector<double>& taper,
                   const MapArea& area, Instructions instructions) {
  MapTile tile;
  const MapSide first = map_side(a, taper), second = map_side(b, taper);
  TileMaker(instructions).make(first, second, area, tile);
  double worst = 0;
  for (int r = 0; r < area.rows; ++r) {
    for (int c = 0; c < area.columns; ++c) {
      const double truth = mean_square(a, area.row + r, b, area.column + c, taper);
      worst = std::max(worst, std::abs(tile.mean_square(r, c) - truth));
    }
  }
  return worst / tile.error;
}

class EveryInstructionSet : public testing::TestWithParam<Instructions> {};

TEST_P(EveryInstructionSet, GivesTheClosedFormToSinglePrecision) {
  const Clouds a = random_clouds(1, 160, 7), b = random_clouds(2, 140, 7);
  Clouds same = b;
  same.weights = a.weights;
  EXPECT_LT(worst_error(a, same, even_taper(13), {0, 0, 148, 128}, GetParam()), 1);
}

TEST_P(EveryInstructionSet, WeighsTheFramesOfAWindow) {
  const Clouds a = random_clouds(3, 90, 5), b{random_clouds(4, 80, 5).points, a.weights};
  EXPECT_LT(worst_error(a, b, uneven_taper(11), {0, 0, 80, 70}, GetParam()), 1);
}

TEST_P(EveryInstructionSet, MakesAnyPartOfAMapFarFromTheOrigin) {
  const Clouds a = random_clouds(5, 90, 31, 40),
               b{random_clouds(6, 120, 31, -70).points, a.weights};
  EXPECT_LT(worst_error(a, b, even_taper(4), {17, 41, 66, 35}, GetParam()), 1);
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, EveryInstructionSet,
                         testing::ValuesIn(usable_instructions()), [](const auto& set) {
                           return std::to_string(static_cast<int>(set.param));
                         });

TEST(DistanceMap, SaysHowWrongItMayBe) {
  const Clouds a = random_clouds(7, 60, 20);
  MapTile tile;
  const MapSide side = map_side(a, even_taper(10));
  TileMaker().make(side, side, {0, 0, 51, 51}, tile);
  EXPECT_LT(tile.error, 1e-5);
  EXPECT_GT(tile.error, 1e-7);
}

TEST(DistanceMap, AreasMeetEveryPairOnce) {
  const int rows = 1100, columns = 700;
  Eigen::MatrixXi met = Eigen::MatrixXi::Zero(rows, columns);
  for (const MapArea& area : map_areas(rows, columns, false)) {
    met.block(area.row, area.column, area.rows, area.columns).array() += 1;
  }
  EXPECT_EQ(met.minCoeff(), 1);
  EXPECT_EQ(met.maxCoeff(), 1);
}

TEST(DistanceMap, OfATakeWithItselfIsHalfAMap) {
  const int windows = 1700;
  Eigen::MatrixXi met = Eigen::MatrixXi::Zero(windows, windows);
  for (const MapArea& area : map_areas(windows, windows, true)) {
    met.block(area.row, area.column, area.rows, area.columns).array() += 1;
  }
  EXPECT_EQ(met.maxCoeff(), 1);
  for (int r = 0; r < windows; ++r) EXPECT_EQ(met.row(r).tail(windows - r).minCoeff(), 1) << r;
  EXPECT_EQ(met(windows - 1, 0), 0);
}

TEST(DistanceMap, TilesArriveOnceEach) {
  const Clouds a = random_clouds(8, 600, 2), b{random_clouds(9, 30, 2).points, a.weights};
  std::mutex mutex;
  int pairs = 0;
  for_each_tile(a, b, even_taper(3), [&](const MapTile& tile) {
    const std::lock_guard lock(mutex);
    pairs += static_cast<int>(tile.mean_square.size());
  });
  EXPECT_EQ(pairs, 598 * 28);
}

TEST(DistanceMap, ATakeShorterThanAWindowHasNone) {
  const Clouds a = random_clouds(10, 5, 3);
  EXPECT_EQ(map_side(a, even_taper(6)).windows(), 0);
  EXPECT_TRUE(map_areas(0, 7, false).empty());
}

TEST(DistanceMap, APointThatIsNoNumberIsInfinitelyFar) {
  Clouds a = random_clouds(11, 40, 3);
  a.points(1, 3 * 20 + 2) = std::numeric_limits<double>::quiet_NaN();
  const MapSide side = map_side(a, even_taper(5));
  MapTile tile;
  TileMaker().make(side, side, {0, 0, 36, 36}, tile);
  EXPECT_TRUE(std::isinf(tile.mean_square(16, 0)) && std::isinf(tile.mean_square(0, 20)));
  EXPECT_NEAR(tile.mean_square(15, 0), mean_square(a, 15, a, 0, even_taper(5)), tile.error);
  EXPECT_NEAR(tile.mean_square(30, 21), mean_square(a, 30, a, 21, even_taper(5)), tile.error);
}

}  // namespace
}  // namespace promenade::motion
