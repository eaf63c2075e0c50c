#include "motion/graph/map_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <mutex>

#include "motion/graph/all_cores.h"

namespace promenade::motion {
namespace {

// Takes in a row, along one side of the picture.
struct Edge {
  std::vector<MapSide> sides;
  std::vector<int> starts = {0};
  int cells = 0;

  int cell(int window) const {
    return static_cast<int>(std::int64_t{window} * cells / starts.back());
  }
};

Edge make_edge(const std::vector<const Clouds*>& takes, std::span<const double> taper, int most) {
  Edge edge;
  for (const Clouds* take : takes) {
    edge.sides.push_back(map_side(*take, taper));
    edge.starts.push_back(edge.starts.back() + edge.sides.back().windows());
  }
  edge.cells = std::min(most, edge.starts.back());
  return edge;
}

struct Piece {
  std::size_t down, across;  // takes
  MapArea area;
};

std::vector<Piece> make_pieces(const Edge& down, const Edge& across, bool symmetric) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < down.sides.size(); ++i) {
    for (std::size_t j = symmetric ? i : 0; j < across.sides.size(); ++j) {
      const bool same = symmetric && i == j;
      for (const MapArea& area :
           map_areas(down.sides[i].windows(), across.sides[j].windows(), same)) {
        pieces.push_back({i, j, area});
      }
    }
  }
  return pieces;
}

// Takes the smallest mean squares of a tile into the picture, `row` and `column` windows into it.
void reduce(const MapTile& tile, const Edge& down, int row, const Edge& across, int column,
            Eigen::MatrixXf& picture) {
  for (int r = 0; r < tile.area.rows; ++r) {
    const int y = down.cell(row + r);
    for (int c = 0; c < tile.area.columns; ++c) {
      float& least = picture(y, across.cell(column + c));
      least = std::min(least, tile.mean_square(r, c));
    }
  }
}

}  // namespace

MapPicture map_picture(const std::vector<const Clouds*>& down,
                       const std::vector<const Clouds*>& across, std::span<const double> taper,
                       int most_rows, int most_columns) {
  assert(most_rows > 0 && most_columns > 0 && "a picture has cells");
  const bool symmetric = &down == &across && most_rows == most_columns;
  const Edge rows = make_edge(down, taper, most_rows);
  const Edge columns = symmetric ? rows : make_edge(across, taper, most_columns);
  MapPicture picture = {{}, rows.starts, columns.starts};
  picture.rms.setConstant(rows.cells, columns.cells, std::numeric_limits<float>::infinity());
  const std::vector<Piece> pieces = make_pieces(rows, columns, symmetric);
  std::mutex mutex;  // of picture.rms
  for_each_piece(static_cast<int>(pieces.size()), [&](int number) {
    const Piece& piece = pieces[static_cast<std::size_t>(number)];
    MapTile tile;
    TileMaker().make(rows.sides[piece.down], columns.sides[piece.across], piece.area, tile);
    const std::lock_guard lock(mutex);
    reduce(tile, rows, rows.starts[piece.down] + piece.area.row, columns,
           columns.starts[piece.across] + piece.area.column, picture.rms);
  });
  if (symmetric) picture.rms = picture.rms.cwiseMin(picture.rms.transpose()).eval();
  picture.rms = picture.rms.cwiseSqrt().eval();
  return picture;
}

}  // namespace promenade::motion
