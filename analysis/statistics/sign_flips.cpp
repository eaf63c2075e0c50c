#include "analysis/statistics/sign_flips.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace promenade::analysis {
namespace {

// Counts in units of the smallest normal number: 2000 doublings still fit.
constexpr int unit = -1022;

// counts[sum] += counts[sum - step] for all sums from step to top, the largest first. Within a
// stretch of `step` sums none is read that was written, so that the compiler may pack them.
void add_shifted(double* counts, std::size_t top, std::size_t step) {
  for (std::size_t end = top + 1; end > step;) {
    const std::size_t length = std::min(step, end - step);
    end -= length;
    double* __restrict to = counts + end;
    const double* __restrict from = counts + end - step;
    for (std::size_t i = 0; i < length; ++i) to[i] += from[i];
  }
}

// In how many ways some of the ranks, each `one`, make the sums 0, 1, ... up to `last` or to
// the sum of all. The counts are symmetric, so only the lower half is added up.
std::vector<double> counts_of(const std::vector<std::int64_t>& ranks, std::size_t last,
                              double one) {
  std::size_t all = 0;
  for (const std::int64_t rank : ranks) all += static_cast<std::size_t>(rank);
  std::vector<double> counts(std::min(all, last) + 1, 0.0);
  counts[0] = one;
  std::size_t total = 0;  // of the ranks so far
  const auto mirror = [&](std::size_t from, std::size_t to) {
    for (std::size_t sum = from; sum <= to && sum <= total; ++sum)
      counts[sum] = counts[total - sum];
  };
  for (const std::int64_t rank : ranks) {
    const auto step = static_cast<std::size_t>(rank);
    const std::size_t top = std::min((total + step) / 2, last);
    mirror(total / 2 + 1, top);
    add_shifted(counts.data(), top, step);
    total += step;
  }
  mirror(total / 2 + 1, counts.size() - 1);
  return counts;
}

}  // namespace

std::vector<double> sign_flip_distribution(std::vector<std::int64_t> ranks, std::int64_t last) {
  assert(ranks.size() <= sign_flips_limit && "too many ranks for exact counts");
  assert(last >= 0 && "the sum of ranks is never negative");
  std::sort(ranks.begin(), ranks.end());  // small sums first: fewer entries to visit
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

// One half in the smallest unit and one in ones, so that products of 1000 doublings each fit.
SignFlipTail sign_flip_tail(std::vector<std::int64_t> ranks, std::int64_t last) {
  assert(ranks.size() <= sign_flips_limit && "too many ranks for exact counts");
  assert(last >= 0 && "the sum of ranks is never negative");
  std::sort(ranks.begin(), ranks.end());
  std::vector<std::int64_t> halves[2];
  for (std::size_t i = 0; i < ranks.size(); ++i) halves[i % 2].push_back(ranks[i]);
  const auto end = static_cast<std::size_t>(last);
  const std::vector<double> left = counts_of(halves[0], end, std::ldexp(1.0, unit));
  const std::vector<double> right = counts_of(halves[1], end, 1);
  SignFlipTail tail;
  double up_to = 0;      // the sum of right[0 .. last - sum]
  std::size_t next = 0;  // the first that is not in it
  for (std::size_t sum = left.size(); sum-- > 0;) {
    const std::size_t rest = end - sum;
    for (; next < right.size() && next < rest; ++next) up_to += right[next];
    tail.below += left[sum] * up_to;
    if (rest < right.size()) tail.at += left[sum] * right[rest];
  }
  const int scale = -unit - static_cast<int>(ranks.size());
  return {std::ldexp(tail.below, scale), std::ldexp(tail.at, scale)};
}

}  // namespace promenade::analysis
