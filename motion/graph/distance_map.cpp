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

constexpr int tile_windows = 640;  // along both sides: the second cache holds what is in use
constexpr int block_frames = 8;    // of A, multiplied while a panel of B is in the first cache
constexpr int restart_rows = 64;   // running sums begin anew: rounding must not pile up
// The rounding error of a mean square, in units of the last digit of the largest square of a window
// in the tile. In walks and random motions of 5 to 31 points the worst of 100,000 pairs had 10.
constexpr float error_steps = 20;
constexpr double farthest = 1e9;
constexpr double no_motion = 1e-9;
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

// The middle of the ground that the take walks over.
Eigen::Vector3d middle_of(const Clouds& clouds, const std::vector<bool>& usable) {
  const Index points = clouds.weights.size();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Index used = 0;
  for (int f = 0; f < clouds.frames(); ++f) {
    if (!usable[static_cast<std::size_t>(f)]) continue;
    sum += clouds.points.middleCols(f * points, points).rowwise().sum();
    used += points;
  }
  if (used > 0) sum /= static_cast<double>(used);
  return {sum.x(), 0, sum.z()};
}

void take_points(const Clouds& clouds, const std::vector<bool>& usable, MapSide& side) {
  const Index points = clouds.weights.size();
  const Eigen::Vector3d middle = middle_of(clouds, usable);
  side.x = clouds.points.row(0).array() - middle.x();
  side.y = clouds.points.row(1).array();
  side.z = clouds.points.row(2).array() - middle.z();
  for (int f = 0; f < clouds.frames(); ++f) {
    if (usable[static_cast<std::size_t>(f)]) continue;
    for (ArrayXd* row : {&side.x, &side.y, &side.z}) row->segment(f * points, points).setZero();
  }
}

// Whether no point has moved since the frame before.
bool stands_still(const MapSide& side, Index frame) {
  const Index points = side.weights.size();
  for (const ArrayXd* row : {&side.x, &side.y, &side.z}) {
    const auto now = row->segment(frame * points, points);
    const auto before = row->segment((frame - 1) * points, points);
    if (((now - before).abs() > no_motion).any()) return false;
  }
  return true;
}

std::vector<bool> repeating_windows(const MapSide& side) {
  std::vector<bool> repeats(side.usable.size());
  int still = 0;  // frames in a row, up to f
  for (int f = 1; f < side.clouds->frames(); ++f) {
    still = stands_still(side, f) ? still + 1 : 0;
    const int first = f + 1 - side.window();
    if (first >= 1) repeats[static_cast<std::size_t>(first)] = still >= side.window();
  }
  return repeats;
}

// Weighted sums of the frames of a take: x, z, y, y^2, x^2 + z^2.
Eigen::Array<double, 5, Eigen::Dynamic> frame_moments(const MapSide& side) {
  const Index points = side.weights.size();
  Eigen::Array<double, 5, Eigen::Dynamic> moments(5, side.clouds->frames());
  for (Index f = 0; f < moments.cols(); ++f) {
    const auto x = side.x.segment(f * points, points);
    const auto y = side.y.segment(f * points, points);
    const auto z = side.z.segment(f * points, points);
    const auto w = side.weights.array();
    moments.col(f) << (w * x).sum(), (w * z).sum(), (w * y).sum(), (w * y.square()).sum(),
        (w * (x.square() + z.square())).sum();
  }
  return moments;
}

WindowMoments window_moments(const MapSide& side) {
  const auto frames = frame_moments(side);
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
  take_points(clouds, frames, side);
  side.repeats = repeating_windows(side);
  side.moments = window_moments(side);
  return side;
}

bool is_even(std::span<const double> taper) {
  return std::all_of(taper.begin(), taper.end(),
                     [&](double weight) { return weight == taper.front(); });
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
  even_ = is_even(a.taper);
  taper_.assign(a.taper.begin(), a.taper.end());
  if (even_) std::fill(taper_.begin(), taper_.end(), 1.0F);
  const auto in_a = [&](const ArrayXd& of) { return middle(of, a.usable, area.row, area.rows); };
  const auto in_b = [&](const ArrayXd& of) {
    return middle(of, b.usable, area.column, area.columns);
  };
  const Origin origin = {in_a(a.moments.x), in_a(a.moments.z), in_b(b.moments.x), in_b(b.moments.z),
                         0.5 * (in_a(a.moments.y) + in_b(b.moments.y))};
  pack_first(a, area, origin);
  pack_second(b, area, origin);
  const float largest_a =
      fill_windows(a, area.row, area.rows, {origin.ax, origin.y, origin.az}, spread_a_, x_a_, z_a_);
  const float largest_b = fill_windows(b, area.column, area.columns,
                                       {origin.bx, origin.y, origin.bz}, spread_b_, x_b_, z_b_);
  tile.area = area;
  tile.error = error_steps * std::numeric_limits<float>::epsilon() * std::max(largest_a, largest_b);
  make_rows(tile);
}

void TileMaker::pack_first(const MapSide& side, const MapArea& area, const Origin& origin) {
  const int frames = area.rows + window_ - 1;
  fours_.assign(static_cast<std::size_t>(rounded_up(frames, block_frames) * points_) * 3, 0);
  const double share = even_ ? side.taper.front() : 1;
  for (int f = 0; f < frames; ++f) {
    const Index from = static_cast<Index>(area.row + f) * points_;
    float* at = fours_.data() + (f / 4 * points_ * 4 + f % 4) * 3;
    for (int m = 0; m < points_; ++m, at += four_floats) {
      const double weight = share * side.weights(m);
      at[0] = static_cast<float>(weight * (side.x(from + m) - origin.ax));
      at[1] = static_cast<float>(weight * (side.z(from + m) - origin.az));
      at[2] = static_cast<float>(weight * (side.y(from + m) - origin.y));
    }
  }
}

void TileMaker::pack_second(const MapSide& side, const MapArea& area, const Origin& origin) {
  const int frames = area.columns + window_ - 1;
  const int padded = rounded_up(frames, panel_frames);
  panels_.assign(static_cast<std::size_t>(padded * points_) * 3, 0);
  for (int f = 0; f < frames; ++f) {
    const Index from = static_cast<Index>(area.column + f) * points_;
    float* at = panels_.data() + f / panel_frames * points_ * panel_floats + f % panel_frames;
    for (int m = 0; m < points_; ++m, at += panel_floats) {
      at[0] = static_cast<float>(side.x(from + m) - origin.bx);
      at[panel_frames] = static_cast<float>(side.z(from + m) - origin.bz);
      at[2 * panel_frames] = static_cast<float>(side.y(from + m) - origin.y);
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
  rows_.clear();
  for (int p = 0; p < window_; ++p) rows_.push_back(ring_row(row + p));
  const auto stride = static_cast<int>(sums_.size() / 3);
  float* const at = sums_.data() + area_.rows - 1 - row;
  const ThreeRows<float> sums = {at, at + stride, at + 2 * stride};
  if (!even_ || row % restart_rows == 0) {
    kernels_.weigh(area_.columns, window_, taper_.data(), rows_.data(), sums);
    return;
  }
  const ThreeRows<float> in = rows_.back(), out = ring_row(row - 1);
  kernels_.slide(area_.columns - 1, {in.c + window_, in.s + window_, in.y + window_},
                 {out.c, out.s, out.y}, {sums.c + 1, sums.s + 1, sums.y + 1});
  float first[3 * panel_frames];  // the first window has none before it
  kernels_.weigh(1, window_, taper_.data(), rows_.data(),
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
