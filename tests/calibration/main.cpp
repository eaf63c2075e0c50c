// Calibration of the report's tests, as the tables of results/validation.md. Exit code 1 when
// the test on one value per person rejects more or less often than it may.
//
//     calibration [--studies N] [--coverage N] [--seed S]
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/print.h"
#include "calibration.h"

namespace {

using namespace promenade;
using calibration::Coverage;
using calibration::Setting;
using calibration::Size;

// True where nothing is wrong.
bool print_size(const Size& size) {
  std::string expected = "|  |  |";
  bool good = true;
  if (size.expected > 0) {
    const auto limits = calibration::binomial_limits(size.studies, size.expected, 0.99);
    good = limits.least <= size.rejected && size.rejected <= limits.most;
    expected = fmt::format("| {:.4f} | {} to {}{} |", size.expected, limits.least, limits.most,
                           good ? "" : " **OUTSIDE**");
  }
  fmt::print("| {} | {} | {} | {:.4f} {}\n", size.measure, size.test, size.rejected,
             static_cast<double>(size.rejected) / size.studies, expected);
  return good;
}

bool print_sizes(const Setting& setting) {
  fmt::print(
      "\nThe same interface under two names: {} studies of {} people, aptitude {}, seed {}\n\n",
      setting.studies, setting.people, setting.aptitude, setting.seed);
  fmt::print(
      "| measure | test | rejected | share | expected | 99 % limits |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  bool good = true;
  double untied = 0;
  for (const Size& size : calibration::sizes_where_nothing_differs(setting)) {
    good = print_size(size) && good;
    if (size.measure == "d_final" && size.expected > 0) untied = size.untied;
  }
  std::fflush(stdout);
  fmt::print("\nFinal D was without ties in {:.1f} % of the studies.\n", 100 * untied);
  return good;
}

void print_coverage(const Setting& setting, int people) {
  fmt::print(
      "\nCoverage: {} studies of {} people, aptitude {}; twice as hard with one interface\n\n",
      setting.studies, setting.people, setting.aptitude);
  fmt::print(
      "| measure | shift in the large run | people | covered | share | level |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  for (const Coverage& one : calibration::coverage_of_intervals(setting, people)) {
    fmt::print("| {} | {:.5g} | {} | {} of {} | {:.4f} | {:.4f} |\n", one.measure, one.shift,
               one.people, one.covered, one.studies,
               one.studies == 0 ? 0.0 : static_cast<double>(one.covered) / one.studies, one.level);
  }
}

int run(Setting setting, int large_run) {
  app::interrupted();
  setting.progress = [](const std::string& what, int done, int count) {
    app::show_progress(what, done, count);
    return !app::interrupted();
  };
  std::vector<double> untied;
  for (int i = 1; i <= setting.people; ++i) untied.push_back(i);
  fmt::print("Attainable size of the exact test at {} for {} untied differences: {:.6f}\n",
             setting.alpha, setting.people, calibration::attainable_size(untied, setting.alpha));
  bool good = true;
  for (const double aptitude : {0.0, 0.5}) {
    setting.aptitude = aptitude;
    good = print_sizes(setting) && good;
  }
  if (large_run > 0) print_coverage(setting, large_run);
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Calibration of the report's tests");
  Setting setting;
  int large_run = 20'000;
  program.add_option("--studies", setting.studies)->check(CLI::Range(1, 1'000'000));
  program.add_option("--coverage", large_run, "people of the large run; 0: no coverage");
  program.add_option("--people", setting.people)->check(CLI::Range(1, 20));
  program.add_option("--seed", setting.seed);
  CLI11_PARSE(program, argc, argv);
  try {
    return run(setting, large_run);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
