#include "motion/quantile.h"

#include <algorithm>
#include <cassert>

namespace promenade::motion {

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return quantile_of_sorted(values, share);
}

double quantile_of_sorted(const std::vector<double>& sorted, double share) {
  assert(!sorted.empty() && share >= 0 && share <= 1 && "a share of some values");
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace promenade::motion
