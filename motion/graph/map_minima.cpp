#include "motion/graph/map_minima.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/graph/diagonal_distances.h"
#include "motion/graph/window_distance.h"

namespace promenade::motion {
namespace {

constexpr double tie = 1e-5;  // metres: below it distances are the same

// The area with its neighbours, as far as the map goes.
MapArea with_margin(const MapArea& area, int rows, int columns) {
  const int row = std::max(0, area.row - 1), column = std::max(0, area.column - 1);
  return {row, column, std::min(rows, area.row + area.rows + 1) - row,
          std::min(columns, area.column + area.columns + 1) - column};
}

class Search {
 public:
  Search(const MapSide& a, const MapSide& b, const MapArea& area, const MinimaQuery& query)
      : a_(a),
        b_(b),
        area_(area),
        query_(query),
        distances_(a, b, with_margin(area, a.windows(), b.windows())) {
    TileMaker(query.instructions).make(a, b, with_margin(area, a.windows(), b.windows()), tile_);
  }

  MapMinima run() {
    const std::size_t width = static_cast<std::size_t>(tile_.area.columns) + 2;
    nowhere_.assign(width, std::numeric_limits<float>::infinity());
    for (auto& row : rows_) row = nowhere_;
    least_.resize(width);
    load(area_.row - 1);
    load(area_.row);
    for (int r = area_.row; r < area_.row + area_.rows; ++r) {
      load(r + 1);
      if (!a_.repeats[static_cast<std::size_t>(r)]) search_row(r);
    }
    return std::move(minima_);
  }

 private:
  // A row of the map with a border, so that there are neighbours everywhere.
  std::vector<float>& row(int r) { return rows_[static_cast<std::size_t>(r + 3) % 3]; }

  void load(int r) {
    const int in_tile = r - tile_.area.row;
    std::vector<float>& to = row(r);
    if (in_tile < 0 || in_tile >= tile_.area.rows) {
      to = nowhere_;
    } else {
      const float* from = tile_.mean_square.row(in_tile).data();
      std::copy(from, from + tile_.area.columns, to.begin() + 1);
    }
  }

  void search_row(int r) {
    const int first = area_.column - tile_.area.column + 1;
    const float* const values = row(r).data() + first;
    map_kernels(query_.instructions)
        .least_neighbours(area_.columns, row(r - 1).data() + first, values,
                          row(r + 1).data() + first, least_.data());
    int from = 0, to = area_.columns;
    if (&a_ == &b_) {
      from = std::max(from, r + query_.least_apart - area_.column);
      to = static_cast<int>(
          std::min<std::int64_t>(to, std::int64_t{r} + query_.most_apart - area_.column + 1));
    }
    for (int n = from; n < to; ++n) {
      if (values[n] <= least_[static_cast<std::size_t>(n)] + slack(values[n])) {
        consider(r, area_.column + n, values[n], least_[static_cast<std::size_t>(n)]);
      }
    }
  }

  // By how much mean squares can differ and still be in either order.
  float slack(float mean_square) const {
    return 2 * tile_.error + static_cast<float>(2 * tie) * std::sqrt(mean_square);
  }

  void consider(int r, int c, float value, float least) {
    if (!std::isfinite(value) || b_.repeats[static_cast<std::size_t>(c)]) return;
    const bool certain = value + slack(least) < least;
    const double limit = query_.most_rms * query_.most_rms;
    const bool wanted = value <= limit + static_cast<double>(tile_.error);
    if (!certain && !is_minimum(r, c)) return;
    ++minima_.count;
    if (!wanted) return;
    const WindowDistance distance = between(r, c);
    if (distance.rms() <= query_.most_rms) {
      minima_.found.push_back({r, c, distance.rms(), distance.move});
    }
  }

  bool is_minimum(int r, int c) {
    const std::int64_t level = level_of(r, c);
    // Those along the diagonal first: they are the most alike, and one smaller is enough.
    constexpr std::array<std::array<int, 2>, 8> neighbours = {
        {{-1, -1}, {1, 1}, {-1, 0}, {0, -1}, {0, 1}, {1, 0}, {-1, 1}, {1, -1}}};
    return std::none_of(neighbours.begin(), neighbours.end(), [&](const auto& step) {
      const int row = r + step[0], column = c + step[1];
      if (!in_map(row, column)) return false;
      const std::int64_t other = level_of(row, column);
      const bool before = row < r || (row == r && column < c);
      return before ? other <= level : other < level;
    });
  }

  bool in_map(int r, int c) const {
    return r >= 0 && c >= 0 && r < a_.windows() && c < b_.windows() &&
           a_.usable[static_cast<std::size_t>(r)] && b_.usable[static_cast<std::size_t>(c)];
  }

  WindowDistance between(int r, int c) const {
    return window_distance(*a_.clouds, r, *b_.clouds, c + b_.window() - 1, a_.taper);
  }

  std::int64_t level_of(int r, int c) {
    return std::llround(std::sqrt(distances_.mean_square(r, c)) / tie);
  }

  const MapSide& a_;
  const MapSide& b_;
  MapArea area_;
  MinimaQuery query_;
  MapTile tile_;
  DiagonalDistances distances_;
  std::array<std::vector<float>, 3> rows_;
  std::vector<float> nowhere_, least_;
  MapMinima minima_;
};

}  // namespace

std::vector<MapArea> minima_areas(const MapSide& a, const MapSide& b, const MinimaQuery& query) {
  std::vector<MapArea> areas = map_areas(a.windows(), b.windows(), &a == &b);
  if (&a != &b) return areas;
  std::erase_if(areas, [&](const MapArea& area) {
    const int least = area.column - (area.row + area.rows - 1);
    const int most = area.column + area.columns - 1 - area.row;
    return least > query.most_apart || most < query.least_apart;
  });
  return areas;
}

MapMinima minima_in(const MapSide& a, const MapSide& b, const MapArea& area,
                    const MinimaQuery& query) {
  return Search(a, b, area, query).run();
}

}  // namespace promenade::motion
