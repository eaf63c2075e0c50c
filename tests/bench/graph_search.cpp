// Searching graphs. Run: build/release/tests/bench_graph_search
#include <benchmark/benchmark.h>

#include "motion/graph/digraph.h"
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

}  // namespace
}  // namespace promenade::motion
