// Distances of motion graphs, at the size of the papers: a take of 10,000 frames of 31 joints
// against itself, windows of 40 frames. "rate" is in multiplications and additions a second.
// Run: build/release/tests/bench_graph
#include <benchmark/benchmark.h>

#include "motion/angles.h"
#include "motion/graph/diagonal_distances.h"
#include "motion/graph/map_minima.h"
#include "motion/graph/matches.h"
#include "motion/graph/window_distance.h"
#include "tests/motion/graph/random_clouds.h"

namespace promenade::motion {
namespace {

constexpr int joints = 31;
constexpr int window = 40;
constexpr double frame_time = 1.0 / 120;

// Somebody who walks in circles, with steps that are never quite the same. 120 frames a second.
Clouds walk(std::uint64_t seed, int frames) {
  Random random(seed);
  const Eigen::Matrix3Xd body = 0.4 * random.normals(3, joints);
  const Eigen::Matrix3Xd swing = 0.1 * random.normals(3, joints);
  const Eigen::Matrix3Xd start = 3 * random.normals(3, joints);
  Clouds clouds = {Eigen::Matrix3Xd(3, frames * joints), Eigen::VectorXd::Ones(joints) / joints};
  double phase = 0, heading = 0;
  for (int f = 0; f < frames; ++f) {
    phase += 2 * pi * frame_time / (1.1 + 0.15 * std::sin(0.0017 * f));
    heading += 0.4 * frame_time * (1 + std::sin(0.0031 * f));
    const double mood = 1 + 0.3 * std::sin(0.0007 * f);
    const PlanarMove place{heading, 3 * std::sin(0.9 * heading), 3 * std::cos(0.9 * heading)};
    for (int m = 0; m < joints; ++m) {
      const Eigen::Vector3d at =
          body.col(m).array() + mood * swing.col(m).array() * (start.col(m).array() + phase).sin();
      clouds.points.col(f * joints + m) = moved(place, at);
    }
  }
  return clouds;
}

const Clouds& long_take() {
  static const Clouds clouds = walk(1, 10000);
  return clouds;
}

bool usable(benchmark::State& state, Instructions instructions) {
  state.SetLabel(name_of(instructions));
  const auto sets = usable_instructions();
  if (std::find(sets.begin(), sets.end(), instructions) != sets.end()) return true;
  state.SkipWithError("this processor has no such instructions");
  return false;
}

Instructions set_of(const benchmark::State& state) {
  return static_cast<Instructions>(state.range(0));
}

// One pair of windows by the closed form in double.
void window_pair(benchmark::State& state) {
  const std::vector<double> taper = even_taper(window);
  int j = window - 1;
  for (auto _ : state) {
    j = j < 9000 ? j + 7 : window - 1;
    benchmark::DoNotOptimize(window_distance(long_take(), 100, long_take(), j, taper).sum);
  }
}
BENCHMARK(window_pair);

// The same when only its size is asked for, of takes that are prepared.
void window_pair_prepared(benchmark::State& state) {
  const MapSide side = map_side(long_take(), even_taper(window));
  int c = 0;
  for (auto _ : state) {
    c = c < 9000 ? c + 7 : 0;
    DiagonalDistances distances(side, side, {100, c, 1, 1});
    benchmark::DoNotOptimize(distances.mean_square(100, c));
  }
}
BENCHMARK(window_pair_prepared);

void count_products(benchmark::State& state, double frame_pairs, int points) {
  const double operations = 2 * 5 * points * frame_pairs;
  state.counters["rate"] = benchmark::Counter(operations, benchmark::Counter::kIsRate);
}

// What the inner loop reaches on frames of so many points that are in the first cache.
void products(benchmark::State& state) {
  if (!usable(state, set_of(state))) return;
  const int points = static_cast<int>(state.range(1));
  const MapKernels& kernels = map_kernels(set_of(state));
  std::vector<float> four(static_cast<std::size_t>(points * four_floats), 0.5F);
  std::vector<float> panel(static_cast<std::size_t>(points * panel_floats), 0.25F);
  std::vector<float> out(static_cast<std::size_t>(4 * panel_floats));
  ThreeRows<float> rows[4];
  for (int r = 0; r < 4; ++r) {
    float* const row = out.data() + r * panel_floats;
    rows[r] = {row, row + panel_frames, row + 2 * panel_frames};
  }
  for (auto _ : state) {
    kernels.products(points, four.data(), panel.data(), rows);
    benchmark::ClobberMemory();
  }
  count_products(state, 4.0 * panel_frames * static_cast<double>(state.iterations()), points);
}
BENCHMARK(products)->ArgNames({"set", "points"})->ArgsProduct({{0, 1, 2}, {31, 256}});

// The map on one core, by instruction set; even or tapered windows.
void map(benchmark::State& state) {
  if (!usable(state, set_of(state))) return;
  MatchOptions options;
  options.window_s = window * frame_time;
  options.tapered = state.range(1) == 1;
  const MapSide side = map_side(long_take(), window_taper(options, frame_time));
  const auto areas = map_areas(side.windows(), side.windows(), true);
  TileMaker maker(set_of(state));
  MapTile tile;
  std::size_t next = 0;
  double pairs = 0;
  for (auto _ : state) {
    maker.make(side, side, areas[next], tile);
    benchmark::DoNotOptimize(tile.mean_square.data());
    pairs += static_cast<double>(tile.mean_square.size());
    next = (next + 1) % areas.size();
  }
  count_products(state, pairs, joints);
  state.counters["pair"] =
      benchmark::Counter(pairs, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(map)->ArgNames({"set", "tapered"})->ArgsProduct({{0, 1, 2}, {0, 1}})->MinTime(0.5);

// Half of the map, on all cores.
void all_pairs(benchmark::State& state) {
  for (auto _ : state) {
    for_each_tile(long_take(), long_take(), even_taper(window),
                  [](const MapTile& tile) { benchmark::DoNotOptimize(tile.mean_square.data()); });
  }
}
BENCHMARK(all_pairs)->Unit(benchmark::kMillisecond)->UseRealTime();

// The same with its minima; those below the threshold, or all of them for a quantile.
void matches(benchmark::State& state) {
  const std::vector<LabelledClouds> takes = {{long_take(), ""}};
  MatchOptions options;
  if (state.range(0) == 1) options.quantile = 0.01;
  for (auto _ : state) {
    const Matches found = find_matches(takes, frame_time, options);
    state.counters["minima"] = found.minima;
    state.counters["found"] = static_cast<double>(found.found.size());
  }
}
BENCHMARK(matches)
    ->ArgName("quantile")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace promenade::motion
