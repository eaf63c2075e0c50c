#include "analysis/statistics/sign_flips.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace promenade::analysis {

std::vector<double> sign_flip_distribution(std::vector<std::int64_t> ranks, std::int64_t last) {
  assert(ranks.size() <= sign_flips_limit && "too many ranks for exact counts");
  assert(last >= 0 && "the sum of ranks is never negative");
  std::sort(ranks.begin(), ranks.end());  // small sums first: fewer entries to visit
  // Counts in units of the smallest normal number: 2000 doublings still fit.
  constexpr int unit = -1022;
  const auto size = static_cast<std::size_t>(last) + 1;
  std::vector<double> counts(size, 0.0);
  std::vector<double> next(size, 0.0);
  counts[0] = std::ldexp(1.0, unit);
  std::size_t reach = 0;  // the largest sum so far
  for (const std::int64_t rank : ranks) {
    assert(rank > 0 && "ranks are positive");
    const auto step = static_cast<std::size_t>(rank);
    reach = std::min(reach + step, size - 1);
    const std::size_t same = std::min(step, reach + 1);
    std::copy_n(counts.begin(), same, next.begin());
    for (std::size_t sum = same; sum <= reach; ++sum) next[sum] = counts[sum] + counts[sum - step];
    counts.swap(next);
  }
  const int scale = -unit - static_cast<int>(ranks.size());
  for (double& count : counts) count = std::ldexp(count, scale);
  return counts;
}

}  // namespace promenade::analysis
