// Does a test reject as often as it says where nothing differs, and does an interval cover what
// it says? Answered by studies of simulated people, through the session, the store, the reader
// of the log and the report's tests.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/power/rehearsal.h"

namespace promenade::calibration {

// Of the exact signed-rank test of these differences (zeros dropped, mid-ranks), by going through
// all signs: how likely p <= alpha is. At most 20 differences.
double attainable_size(const std::vector<double>& differences, double alpha);

// Numbers of successes that Bin(n, p) leaves with at least 1 - level, half of it on either side.
struct Limits {
  int least = 0, most = 0;
};
Limits binomial_limits(int n, double p, double level);

// A test in studies where nothing differs.
struct Size {
  std::string measure, test;
  int rejected = 0, studies = 0;
  double expected = 0;  // mean of the attainable sizes; 0: none is known
  double untied = 0;    // share of the studies without ties and zeros
};

struct Setting {
  int studies = 2000, people = 13;
  std::uint64_t seed = 1;
  double aptitude = 0;  // study/simulated.h
  double alpha = 0.05;
  analysis::Progress progress = {};
};

// Two interfaces that are one under two names.
std::vector<Size> sizes_where_nothing_differs(const Setting& setting);

struct Coverage {
  std::string measure;
  double shift = 0;  // of the large run, in the unit of the measure
  int people = 0;    // of the large run who have a difference
  int covered = 0, studies = 0;
  double level = 0;  // what the intervals attain by their own account, on average
};

// One interface is harder. `people` are in the large run.
std::vector<Coverage> coverage_of_intervals(const Setting& setting, int people);

}  // namespace promenade::calibration
