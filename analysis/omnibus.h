// All interfaces compared at once, before pairs are looked at: Friedman's test of one value per
// participant (the mean over targets).
#pragma once

#include <optional>
#include <vector>

#include "analysis/dataset.h"
#include "analysis/statistics/friedman.h"

namespace promenade::analysis {

struct OmnibusTest {
  int measure = 0, task = 0;
  std::vector<int> interfaces = {};  // those with a value, at least three, in their order
  int n = 0;                         // people with a value for each of them: complete cases
  int incomplete = 0;                // people with a value for some of them, left out
  // Conditions are places in `interfaces`. Nothing for no complete case. Values that differ by
  // less than 1e-9 of the largest magnitude are ties (differences.h says why).
  std::optional<FriedmanTest> test = {};
};

// Exact where that can be counted (row_permutations.h), else by the F of Iman & Davenport;
// nothing where every participant has the same value with all interfaces.
std::optional<double> omnibus_p(const OmnibusTest& omnibus);

// For each task and measure that has values for at least three interfaces.
std::vector<OmnibusTest> omnibus_tests(const Dataset& data);

}  // namespace promenade::analysis
