// The tests of a report at sizes far beyond a study's. Run: build/release/tests/bench_statistics
#include <benchmark/benchmark.h>

#include <cmath>

#include "analysis/statistics/bootstrap.h"
#include "analysis/statistics/logrank.h"
#include "analysis/statistics/power_simulated.h"
#include "analysis/statistics/wilcoxon.h"
#include "study/rng.h"

namespace promenade::analysis {
namespace {

// Differences of ratings in steps of a tenth: many ties, and W+ in the middle, where the exact
// p is the most work.
std::vector<double> tied_differences(int n) {
  study::Rng rng(1, 0, "bench");
  std::vector<double> d;
  while (static_cast<int>(d.size()) < n) {
    const double value = std::round(10 * rng.normal()) / 10;
    if (value != 0) d.push_back(value);
  }
  return d;
}

void exact_wilcoxon_with_ties(benchmark::State& state) {
  const std::vector<double> d = tied_differences(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(wilcoxon(d).exact->two);
}
BENCHMARK(exact_wilcoxon_with_ties)->Arg(13)->Arg(200)->Arg(1000)->Unit(benchmark::kMicrosecond);

void bootstrap_medians_10000(benchmark::State& state) {
  const std::vector<double> x = tied_differences(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(bootstrap_replicates(Location::median, x, 10000, 1).data());
  }
}
BENCHMARK(bootstrap_medians_10000)->Arg(13)->Arg(100)->Arg(1000)->Unit(benchmark::kMicrosecond);

void bootstrap_means_10000(benchmark::State& state) {
  const std::vector<double> x = tied_differences(100);
  for (auto _ : state) {
    benchmark::DoNotOptimize(bootstrap_replicates(Location::mean, x, 10000, 1).data());
  }
}
BENCHMARK(bootstrap_means_10000)->Unit(benchmark::kMicrosecond);

void simulated_power_of_10000_studies_of_13(benchmark::State& state) {
  SimulatedStudies studies;
  studies.n = 13;
  studies.shift = 0.8;
  studies.count = 10000;
  for (auto _ : state) benchmark::DoNotOptimize(simulated_power(studies).power);
}
BENCHMARK(simulated_power_of_10000_studies_of_13)->Unit(benchmark::kMicrosecond);

// 65 people, five conditions, everybody a stratum.
void stratified_logrank(benchmark::State& state) {
  study::Rng rng(2, 0, "bench");
  std::vector<GroupedDuration> durations;
  for (int i = 0; i < 65 * 5; ++i) {
    const double time = std::round(400 * rng.uniform());
    durations.push_back({{std::min(time, 300.0), time < 300}, i % 5, i / 5});
  }
  for (auto _ : state) benchmark::DoNotOptimize(logrank(durations, 5).p);
}
BENCHMARK(stratified_logrank)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace promenade::analysis
