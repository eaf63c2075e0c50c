// Searching graphs. Run: build/release/tests/bench_graph_search
#include <benchmark/benchmark.h>

#include "motion/angles.h"
#include "motion/graph/digraph.h"
#include "motion/graph/path_walk.h"
#include "tests/motion/graph/arc_graph.h"
#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

// Six arcs from every node on average, anywhere.
std::vector<Arc> random_arcs(int nodes) {
  Random random(1);
  std::vector<Arc> arcs;
  for (int i = 0; i < 6 * nodes; ++i) {
    arcs.push_back(
        {static_cast<int>(random.uniform() * nodes), static_cast<int>(random.uniform() * nodes)});
  }
  return arcs;
}

void components_of_100_000_nodes(benchmark::State& state) {
  const Digraph graph(100'000, random_arcs(100'000));
  for (auto _ : state) benchmark::DoNotOptimize(strong_components(graph).data());
}
BENCHMARK(components_of_100_000_nodes)->Unit(benchmark::kMillisecond);

void digraph_of_100_000_nodes(benchmark::State& state) {
  const std::vector<Arc> arcs = random_arcs(100'000);
  for (auto _ : state) benchmark::DoNotOptimize(Digraph(100'000, arcs).nodes());
}
BENCHMARK(digraph_of_100_000_nodes)->Unit(benchmark::kMillisecond);

// 200 places; from each, half a second leads straight on or in a turn to two others.
ArcGraph turning_graph() {
  ArcGraph toy;
  Random random(2);
  const int take = toy.add_take("plain");
  for (int node = 0; node < 200; ++node) toy.add_node(take);
  for (int node = 0; node < 200; ++node) {
    for (int e = 0; e < 2; ++e) {
      toy.add_arc(node, static_cast<int>(random.uniform() * 200), 15, 0.65, random.normal() * 0.3);
    }
  }
  return toy;
}

// 30 m on a circle of 3 m; the counter has edges visited per second.
void path_of_30_m(benchmark::State& state) {
  const ArcGraph toy = turning_graph();
  const std::vector<EdgeWay> ways = edge_ways(toy.graph, toy.courses);
  Eigen::Matrix2Xd points(2, 600);
  for (int i = 0; i < 600; ++i) {
    const double angle = i * 10.0 / 599;
    points.col(i) << 3 * (1 - std::cos(angle)), 3 * std::sin(angle);
  }
  const GroundPath path(points);
  PathWalk walk;
  for (auto _ : state) walk = walk_along(toy.graph, ways, path, {});
  state.counters["edges"] = benchmark::Counter(static_cast<double>(walk.visited),
                                               benchmark::Counter::kIsIterationInvariantRate);
  state.counters["rms_m"] = walk.rms_m;
}
BENCHMARK(path_of_30_m)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace promenade::motion
