#include "motion/graph/distance_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <memory>

#include "motion/graph/all_cores.h"

namespace promenade::motion {
namespace {

using Eigen::ArrayXd;
using Eigen::Index;

constexpr int tile_windows = 512;  // along both sides: what stays in the second cache
constexpr int block_frames = 8;    // of A, multiplied while a panel of B is in the first cache
constexpr int restart_rows = 64;   // running sums begin anew: rounding must not pile up
constexpr double farthest = 1e9;
constexpr float infinity = std::numeric_limits<float>::infinity();

int rounded_up(int count, int step) { return (count + step - 1) / step * step; }

bool usable_frame(const Clouds& clouds, int frame) {
  const Index points = clouds.weights.size();
  return (clouds.points.middleCols(frame * points, points).array().abs() < farthest).all();
}

std::vector<bool> usable_frames(const Clouds& clouds) {
  std::vector<bool> usable(static_cast<std::size_t>(clouds.frames()));
  for (std::size_t f = 0; f < usable.size(); ++f) {
    usable[f] = usable_frame(clouds, static_cast<int>(f));
  }
  return usable;
}

// Of each window: whether all of its frames are usable.
std::vector<bool> usable_windows(const std::vector<bool>& frames, std::size_t window) {
  std::vector<bool> usable(frames.size() < window ? 0 : frames.size() - window + 1);
  std::size_t good = 0;  // frames in a row, up to f
  for (std::size_t f = 0; f < frames.size(); ++f) {
    good = frames[f] ? good + 1 : 0;
    if (f + 1 >= window) usable[f + 1 - window] = good >= window;
  }
  return usable;
}

// Weighted sums of the frames of a take: x, z, y, y^2, x^2 + z^2.
Eigen::Array<double, 5, Eigen::Dynamic> frame_moments(const MapSide& side,
                                                      const std::vector<bool>& usable) {
  const Clouds& clouds = *side.clouds;
  const Index points = side.weights.size();
  Eigen::Array<double, 5, Eigen::Dynamic> moments(5, clouds.frames());
  moments.setZero();
  for (int f = 0; f < clouds.frames(); ++f) {
    if (!usable[static_cast<std::size_t>(f)]) continue;
    const auto cloud = clouds.points.middleCols(f * points, points);
    const Eigen::Vector3d mean = cloud * side.weights;
    const Eigen::Vector3d square = cloud.array().square().matrix() * side.weights;
    moments.col(f) << mean.x(), mean.z(), mean.y(), square.y(), square.x() + square.z();
  }
  return moments;
}

WindowMoments window_moments(const MapSide& side, const std::vector<bool>& usable) {
  const auto frames = frame_moments(side, usable);
  const int windows = side.windows();
  Eigen::Array<double, 5, Eigen::Dynamic> sums(5, windows);
  sums.setZero();
  for (int p = 0; p < side.window() && windows > 0; ++p) {
    sums += side.taper[static_cast<std::size_t>(p)] * frames.middleCols(p, windows);
  }
  WindowMoments moments;
  moments.x = sums.row(0);
  moments.z = sums.row(1);
  moments.y = sums.row(2);
  moments.yy = sums.row(3);
  moments.ground = sums.row(4).transpose() - moments.x.square() - moments.z.square();
  return moments;
}

// The mean of the windows of an area that can be used.
double middle(const ArrayXd& values, const std::vector<bool>& usable, int first, int count) {
  double sum = 0;
  int used = 0;
  for (int w = first; w < first + count; ++w) {
    if (!usable[static_cast<std::size_t>(w)]) continue;
    sum += values(w);
    ++used;
  }
  return used == 0 ? 0 : sum / used;
}

// Windows of one side, as the kernels want them.
float fill_windows(const MapSide& side, int first, int count, const Eigen::Vector3d& origin,
                   Eigen::ArrayXf& spread, Eigen::ArrayXf& x, Eigen::ArrayXf& z) {
  const WindowMoments& moments = side.moments;
  const double h = origin.y();
  const ArrayXd from_x = moments.x.segment(first, count) - origin.x();
  const ArrayXd from_z = moments.z.segment(first, count) - origin.z();
  const ArrayXd all = moments.ground.segment(first, count) + moments.yy.segment(first, count) -
                      2 * h * moments.y.segment(first, count) + h * h;
  spread = all.cast<float>();
  x = from_x.cast<float>();
  z = from_z.cast<float>();
  double largest = 0;
  for (int w = 0; w < count; ++w) {
    if (side.usable[static_cast<std::size_t>(first + w)]) {
      largest = std::max(largest, all(w) + from_x(w) * from_x(w) + from_z(w) * from_z(w));
    } else {
      spread(w) = infinity;
    }
  }
  return static_cast<float>(largest);
}

}  // namespace

MapSide map_side(const Clouds& clouds, std::span<const double> taper) {
  assert(!taper.empty() && "a window has frames");
  MapSide side;
  side.clouds = &clouds;
  side.weights = clouds.weights / clouds.weights.sum();
  side.taper.assign(taper.begin(), taper.end());
  double sum = 0;
  for (const double weight : taper) sum += weight;
  for (double& weight : side.taper) weight /= sum;
  const std::vector<bool> frames = usable_frames(clouds);
  side.usable = usable_windows(frames, taper.size());
  side.moments = window_moments(side, frames);
  return side;
}

std::vector<MapArea> map_areas(int rows, int columns, bool same) {
  std::vector<MapArea> areas;
  for (int r = 0; r < rows; r += tile_windows) {
    for (int c = same ? r : 0; c < columns; c += tile_windows) {
      areas.push_back(
          {r, c, std::min(tile_windows, rows - r), std::min(tile_windows, columns - c)});
    }
  }
  return areas;
}

TileMaker::TileMaker(Instructions instructions) : kernels_(map_kernels(instructions)) {}

void TileMaker::make(const MapSide& a, const MapSide& b, const MapArea& area, MapTile& tile) {
  assert(a.weights.size() == b.weights.size() && "clouds of the same points");
  assert(area.row >= 0 && area.row + area.rows <= a.windows() && "rows of the map");
  assert(area.column >= 0 && area.column + area.columns <= b.windows() && "columns of the map");
  points_ = static_cast<int>(a.weights.size());
  window_ = a.window();
  area_ = area;
  even_ = std::all_of(a.taper.begin(), a.taper.end(),
                      [&](double weight) { return weight == a.taper.front(); });
  taper_.assign(a.taper.begin(), a.taper.end());
  if (even_) std::fill(taper_.begin(), taper_.end(), 1.0F);
  const auto middle_of = [&](const MapSide& side, const ArrayXd& values, int first, int count) {
    return middle(values, side.usable, first, count);
  };
  const Origin origin = {middle_of(a, a.moments.x, area.row, area.rows),
                         middle_of(a, a.moments.z, area.row, area.rows),
                         middle_of(b, b.moments.x, area.column, area.columns),
                         middle_of(b, b.moments.z, area.column, area.columns),
                         0.5 * (middle_of(a, a.moments.y, area.row, area.rows) +
                                middle_of(b, b.moments.y, area.column, area.columns))};
  pack_first(a, area, origin);
  pack_second(b, area, origin);
  const float largest_a =
      fill_windows(a, area.row, area.rows, {origin.ax, origin.y, origin.az}, spread_a_, x_a_, z_a_);
  const float largest_b = fill_windows(b, area.column, area.columns,
                                       {origin.bx, origin.y, origin.bz}, spread_b_, x_b_, z_b_);
  tile.area = area;
  tile.error = 32 * std::numeric_limits<float>::epsilon() * std::max(largest_a, largest_b);
  make_rows(tile);
}

void TileMaker::pack_first(const MapSide& side, const MapArea& area, const Origin& origin) {
  const int frames = area.rows + window_ - 1;
  fours_.assign(static_cast<std::size_t>(rounded_up(frames, block_frames) * points_) * 3, 0);
  const double share = even_ ? side.taper.front() : 1;
  for (int f = 0; f < frames; ++f) {
    if (!usable_frame(*side.clouds, area.row + f)) continue;
    float* at = fours_.data() + (f / 4 * points_ * 4 + f % 4) * 3;
    for (int m = 0; m < points_; ++m, at += four_floats) {
      const auto point = side.clouds->points.col(static_cast<Index>(area.row + f) * points_ + m);
      const double weight = share * side.weights(m);
      at[0] = static_cast<float>(weight * (point.x() - origin.ax));
      at[1] = static_cast<float>(weight * (point.z() - origin.az));
      at[2] = static_cast<float>(weight * (point.y() - origin.y));
    }
  }
}

void TileMaker::pack_second(const MapSide& side, const MapArea& area, const Origin& origin) {
  const int frames = area.columns + window_ - 1;
  const int padded = rounded_up(frames, panel_frames);
  panels_.assign(static_cast<std::size_t>(padded * points_) * 3, 0);
  for (int f = 0; f < frames; ++f) {
    if (!usable_frame(*side.clouds, area.column + f)) continue;
    float* at = panels_.data() + f / panel_frames * points_ * panel_floats + f % panel_frames;
    for (int m = 0; m < points_; ++m, at += panel_floats) {
      const auto point = side.clouds->points.col(static_cast<Index>(area.column + f) * points_ + m);
      at[0] = static_cast<float>(point.x() - origin.bx);
      at[panel_frames] = static_cast<float>(point.z() - origin.bz);
      at[2 * panel_frames] = static_cast<float>(point.y() - origin.y);
    }
  }
}

void TileMaker::make_rows(MapTile& tile) {
  // Room for a register beyond the last column: what is read or written there is not used.
  constexpr int room = panel_frames;
  stride_ = rounded_up(area_.columns + window_ - 1, panel_frames) + room;
  ring_rows_ = rounded_up(window_ + block_frames, block_frames);
  ring_.resize(static_cast<std::size_t>(ring_rows_ * stride_) * 3);
  sums_.resize(static_cast<std::size_t>(area_.rows + area_.columns + room) * 3);
  tile.mean_square.resize(area_.rows, area_.columns);
  multiplied_ = 0;
  const auto sums_stride = static_cast<int>(sums_.size() / 3);
  for (int r = 0; r < area_.rows; ++r) {
    multiply_until(r + window_);
    sum_row(r);
    const float* const sums = sums_.data() + area_.rows - 1 - r;
    const WindowRow row = {spread_a_(r),     x_a_(r),     z_a_(r),
                           spread_b_.data(), x_b_.data(), z_b_.data()};
    kernels_.finish(area_.columns, {sums, sums + sums_stride, sums + 2 * sums_stride}, row,
                    tile.mean_square.data() + static_cast<Index>(r) * area_.columns);
  }
}

ThreeRows<float> TileMaker::ring_row(int frame) {
  float* const row = ring_.data() + static_cast<std::ptrdiff_t>(frame % ring_rows_) * 3 * stride_;
  return {row, row + stride_, row + 2 * stride_};
}

// Products of all frames of A before `frame` with all of B's.
void TileMaker::multiply_until(int frame) {
  const int panels = (area_.columns + window_ - 1 + panel_frames - 1) / panel_frames;
  for (; multiplied_ < frame; multiplied_ += block_frames) {
    for (int b = 0; b < panels; ++b) {
      const float* const panel = panels_.data() + b * points_ * panel_floats;
      for (int f = multiplied_; f < multiplied_ + block_frames; f += 4) {
        ThreeRows<float> rows[4];
        for (int i = 0; i < 4; ++i) {
          const ThreeRows<float> row = ring_row(f + i);
          const int first = b * panel_frames;
          rows[i] = {row.c + first, row.s + first, row.y + first};
        }
        kernels_.products(points_, fours_.data() + f / 4 * points_ * four_floats, panel, rows);
      }
    }
  }
}

// The sums of the windows of a row: from those of the row before, one frame on, or anew.
void TileMaker::sum_row(int row) {
  std::vector<ThreeRows<float>> rows(static_cast<std::size_t>(window_));
  for (int p = 0; p < window_; ++p) rows[static_cast<std::size_t>(p)] = ring_row(row + p);
  const auto stride = static_cast<int>(sums_.size() / 3);
  float* const at = sums_.data() + area_.rows - 1 - row;
  const ThreeRows<float> sums = {at, at + stride, at + 2 * stride};
  if (!even_ || row % restart_rows == 0) {
    kernels_.weigh(area_.columns, window_, taper_.data(), rows.data(), sums);
    return;
  }
  const ThreeRows<float> in = rows.back(), out = ring_row(row - 1);
  kernels_.slide(area_.columns - 1, {in.c + window_, in.s + window_, in.y + window_},
                 {out.c, out.s, out.y}, {sums.c + 1, sums.s + 1, sums.y + 1});
  float first[3 * panel_frames];  // the first window has none before it
  kernels_.weigh(1, window_, taper_.data(), rows.data(),
                 {first, first + panel_frames, first + 2 * panel_frames});
  *sums.c = first[0];
  *sums.s = first[panel_frames];
  *sums.y = first[2 * panel_frames];
}

void for_each_tile(const Clouds& a, const Clouds& b, std::span<const double> taper,
                   const std::function<void(const MapTile&)>& visit) {
  const MapSide first = map_side(a, taper), second = map_side(b, taper);
  const auto areas = map_areas(first.windows(), second.windows(), &a == &b);
  for_each_piece(static_cast<int>(areas.size()), [&](int piece) {
    TileMaker maker;
    MapTile tile;
    maker.make(first, second, areas[static_cast<std::size_t>(piece)], tile);
    visit(tile);
  });
}

}  // namespace promenade::motion
