#include "analysis/statistics/differences.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace promenade::analysis {
namespace {

// Gives neighbours among the sorted magnitudes one common magnitude.
void snap(std::vector<double>& values, double tolerance) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(values[a]) < std::abs(values[b]);
  });
  double shared = 0;  // magnitude of the group, 0 to begin with
  double before = 0;
  for (const std::size_t i : order) {
    const double magnitude = std::abs(values[i]);
    if (magnitude - before > tolerance) shared = magnitude;
    before = magnitude;
    values[i] = shared == 0 ? 0.0 : std::copysign(shared, values[i]);
  }
}

}  // namespace

Differences paired_differences(const std::vector<std::optional<double>>& x,
                               const std::vector<std::optional<double>>& y) {
  assert(x.size() == y.size() && "paired data have the same length");
  Differences result;
  double largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!x[i] || !y[i]) {
      ++result.missing;
      continue;
    }
    result.values.push_back(*x[i] - *y[i]);
    largest = std::max({largest, std::abs(*x[i]), std::abs(*y[i])});
  }
  snap(result.values, 1e-9 * largest);
  return result;
}

}  // namespace promenade::analysis
