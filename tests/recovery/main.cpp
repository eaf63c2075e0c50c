// From ratings to clusters where the truth is known, as the tables of results/validation.md. Exit
// code 1 when clusters are not found, or sliders are made of nothing.
//
//     recovery [--seeds N]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "motion/quantile.h"
#include "recovery.h"

namespace {

using namespace promenade;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// True where nothing is wrong: clusters are found, and no ratings are refused.
bool print_recovery(int raters, int motions, double cross, int seeds) {
  const recovery::Recovery found = recovery::recover(raters, motions, cross, seeds);
  const auto whole = std::count_if(found.rand_index.begin(), found.rand_index.end(),
                                   [](double index) { return index > 1 - 1e-12; });
  fmt::print("| {} | {} | {} | {:.1f} | {:.3f} | {:.3f} | {} of {} | {} of {} |\n", raters, motions,
             cross, mean(found.kept), mean(found.rand_index),
             motion::quantile(found.rand_index, 0.05), whole, seeds, found.refused, seeds);
  std::fflush(stdout);
  return mean(found.rand_index) > (cross < 0.2 ? 0.95 : 0.5) && found.refused == 0;
}

// `most`: how many may be let through.
bool print_refused(const char* who, int raters, int motions, int refused, int seeds, int most) {
  fmt::print("| {} | {} | {} | {} of {} |\n", who, raters, motions, refused, seeds);
  std::fflush(stdout);
  return seeds - refused <= most;
}

bool run(int seeds) {
  fmt::print(
      "| raters | motions | cross-loadings | pairs kept | mean | 5 % quantile | 1.0 | refused |\n");
  fmt::print("| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  bool good = true;
  for (const double cross : {0.1, 0.3}) {
    for (const int raters : {14, 5}) {
      for (const int motions : {10, 27}) {
        good = print_recovery(raters, motions, cross, seeds) && good;
      }
    }
  }
  fmt::print("\n| who | raters | motions | refused |\n| --- | --- | --- | --- |\n");
  for (const int motions : {10, 27}) {
    good = print_refused("at random", 14, motions,
                         recovery::refused_blind_raters(14, motions, seeds), seeds, 0) &&
           good;
  }
  // Few raters agree by chance on single pairs; the level of the test is 1 of 100.
  for (const int raters : {2, 3}) {
    good = print_refused("at random", raters, 10, recovery::refused_blind_raters(raters, 10, seeds),
                         seeds, 2 + seeds / 25) &&
           good;
  }
  good = print_refused("simulated raters of set A", 14, 10, recovery::refused_raters_of("A", seeds),
                       seeds, seeds) &&
         good;
  good = print_refused("simulated raters of set B", 14, 27, recovery::refused_raters_of("B", seeds),
                       seeds, seeds) &&
         good;
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("From ratings to clusters where the truth is known");
  int seeds = 100;
  program.add_option("--seeds", seeds, "Studies of each kind")->check(CLI::Range(1, 100000));
  CLI11_PARSE(program, argc, argv);
  return run(seeds) ? 0 : 1;
}
