#include "motion/graph/map_minima.h"

#include <gtest/gtest.h>

#include "motion/graph/window_distance.h"
#include "tests/motion/graph/random_clouds.h"

namespace promenade::motion {
namespace {

using Pair = std::pair<int, int>;

// Distances of all pairs of windows, in hundredths of a millimetre.
Eigen::MatrixXd all_levels(const Clouds& a, const Clouds& b, const std::vector<double>& taper) {
  const int window = static_cast<int>(taper.size());
  return Eigen::MatrixXd::NullaryExpr(
      a.frames() - window + 1, b.frames() - window + 1, [&](Eigen::Index r, Eigen::Index c) {
        const int i = static_cast<int>(r), j = static_cast<int>(c) + window - 1;
        return std::round(window_distance(a, i, b, j, taper).rms() * 1e5);
      });
}

// Whether no neighbour comes before the pair, by distance, row and column.
bool is_first(const Eigen::MatrixXd& levels, int r, int c) {
  const int rows = static_cast<int>(levels.rows()), columns = static_cast<int>(levels.cols());
  for (int row = std::max(0, r - 1); row < std::min(r + 2, rows); ++row) {
    for (int column = std::max(0, c - 1); column < std::min(c + 2, columns); ++column) {
      if (std::tuple(levels(row, column), row, column) < std::tuple(levels(r, c), r, c)) {
        return false;
      }
    }
  }
  return true;
}

// By the definition.
std::vector<Pair> minima_by_search(const Eigen::MatrixXd& levels) {
  std::vector<Pair> minima;
  for (int r = 0; r < levels.rows(); ++r) {
    for (int c = 0; c < levels.cols(); ++c) {
      if (is_first(levels, r, c)) minima.emplace_back(r, c);
    }
  }
  return minima;
}

std::vector<Pair> pairs_of(const MapMinima& minima) {
  std::vector<Pair> pairs;
  for (const MapMinimum& at : minima.found) pairs.emplace_back(at.row, at.column);
  return pairs;
}

class MinimaOfEverySet : public testing::TestWithParam<Instructions> {
 protected:
  MinimaQuery query_{.instructions = GetParam()};
};

TEST_P(MinimaOfEverySet, AreThoseOfTheDefinition) {
  const Clouds a = random_clouds(1, 120, 4), b{random_clouds(2, 90, 4).points, a.weights};
  const MapSide first = map_side(a, even_taper(7)), second = map_side(b, even_taper(7));
  const MapMinima minima = minima_in(first, second, {0, 0, 114, 84}, query_);
  const std::vector<Pair> expected = minima_by_search(all_levels(a, b, even_taper(7)));
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(pairs_of(minima), expected);
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, MinimaOfEverySet,
                         testing::ValuesIn(usable_instructions()), [](const auto& set) {
                           return std::to_string(static_cast<int>(set.param));
                         });

TEST(MapMinima, BelongToOneAreaEach) {
  const Clouds a = random_clouds(3, 60, 4), b{random_clouds(4, 60, 4).points, a.weights};
  const MapSide first = map_side(a, uneven_taper(6)), second = map_side(b, uneven_taper(6));
  std::vector<Pair> pairs;
  for (const MapArea& area : {MapArea{0, 0, 55, 20}, {0, 20, 55, 35}}) {
    for (const Pair& pair : pairs_of(minima_in(first, second, area, {}))) pairs.push_back(pair);
  }
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(pairs, minima_by_search(all_levels(a, b, uneven_taper(6))));
}

TEST(MapMinima, OfATakeWithItselfLieAboveTheBand) {
  const Clouds a = random_clouds(5, 100, 4);
  const MapSide side = map_side(a, even_taper(5));
  const MinimaQuery query = {.least_apart = 9, .most_apart = 40};
  std::vector<Pair> expected;
  for (const Pair& pair : minima_by_search(all_levels(a, a, even_taper(5)))) {
    const int apart = pair.second - pair.first;
    if (apart >= 9 && apart <= 40) expected.push_back(pair);
  }
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(pairs_of(minima_in(side, side, {0, 0, 96, 96}, query)), expected);
}

TEST(MapMinima, AboveTheLimitAreCountedOnly) {
  const Clouds a = random_clouds(6, 80, 4), b{random_clouds(7, 80, 4).points, a.weights};
  const MapSide first = map_side(a, even_taper(6)), second = map_side(b, even_taper(6));
  const MapMinima all = minima_in(first, second, {0, 0, 75, 75}, {});
  const MapMinima good = minima_in(first, second, {0, 0, 75, 75}, {.most_rms = 0.6});
  EXPECT_EQ(good.count, all.count);
  EXPECT_LT(good.found.size(), all.found.size());
  for (const MapMinimum& at : good.found) EXPECT_LE(at.rms, 0.6);
  EXPECT_EQ(std::ssize(good.found),
            std::count_if(all.found.begin(), all.found.end(),
                          [](const MapMinimum& at) { return at.rms <= 0.6; }));
}

TEST(MapMinima, AreasOutsideTheBandAreLeftOut) {
  const Clouds a = random_clouds(8, 3000, 1);
  const MapSide side = map_side(a, even_taper(3));
  for (const MapArea& area : minima_areas(side, side, {.least_apart = 3, .most_apart = 500})) {
    EXPECT_LE(area.column - (area.row + area.rows - 1), 500);
  }
  EXPECT_LT(minima_areas(side, side, {.most_apart = 500}).size(),
            minima_areas(side, side, {}).size());
}

}  // namespace
}  // namespace promenade::motion
