#include "analysis/statistics/power_sign_flips.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "analysis/statistics/sign_flips.h"

namespace promenade::analysis {
namespace {

// P(W+ <= last), each rank 1..n chosen with probability p.
double lower_tail(int n, double p, std::int64_t last) {
  std::vector<double> probability(static_cast<std::size_t>(last) + 1, 0.0);
  probability[0] = 1;
  for (std::size_t rank = 1; rank <= static_cast<std::size_t>(n); ++rank) {
    for (std::size_t sum = probability.size(); sum-- > 0;) {
      const double chosen = sum >= rank ? probability[sum - rank] : 0;
      probability[sum] = (1 - p) * probability[sum] + p * chosen;
    }
  }
  return std::accumulate(probability.begin(), probability.end(), 0.0);
}

}  // namespace

std::optional<std::int64_t> critical_rank_sum(int n, double alpha) {
  std::vector<std::int64_t> ranks(static_cast<std::size_t>(n));
  std::iota(ranks.begin(), ranks.end(), 1);
  const std::vector<double> p = sign_flip_distribution(std::move(ranks), n * (n + 1LL) / 4);
  double below = 0;
  std::int64_t t = -1;
  while (t + 1 < static_cast<std::int64_t>(p.size())) {
    below += p[static_cast<std::size_t>(t + 1)];
    if (2 * below > alpha) break;
    ++t;
  }
  if (t < 0) return std::nullopt;
  return t;
}

std::optional<std::int64_t> critical_rank_sum_normal(int n, double alpha) {
  const double mean = n * (n + 1.0) / 4;
  const double sd = std::sqrt(n * (n + 1.0) * (2 * n + 1.0) / 24);
  std::int64_t t = -1;
  for (double next = 0; next < mean; ++next, ++t) {
    if (std::erfc((mean - next) / sd / std::sqrt(2.0)) > alpha) break;
  }
  if (t < 0) return std::nullopt;
  return t;
}

double sign_flip_power(int n, double p_plus, std::optional<std::int64_t> critical) {
  if (!critical) return 0;
  return lower_tail(n, p_plus, *critical) + lower_tail(n, 1 - p_plus, *critical);
}

}  // namespace promenade::analysis
