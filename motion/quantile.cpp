#include "motion/quantile.h"

#include <algorithm>
#include <cassert>

namespace promenade::motion {

double quantile(std::vector<double> values, double share) {
  assert(!values.empty() && share >= 0 && share <= 1 && "a share of some values");
  std::sort(values.begin(), values.end());
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (at - static_cast<double>(below)) * (values[above] - values[below]);
}

}  // namespace promenade::motion
