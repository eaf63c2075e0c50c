#include "analysis/statistics/wilcoxon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "analysis/statistics/sign_flips.h"

namespace promenade::analysis {
namespace {

// The non-zero differences: twice the midrank, and the sign. Doubled, midranks
// are whole numbers and W exact.
struct SignedRank {
  std::int64_t doubled_rank = 0;
  bool positive = false;
};

// Counts the ties in `test`.
std::vector<SignedRank> rank(const std::vector<double>& d, Zeros zeros, SignedRankTest& test) {
  std::vector<double> sorted;
  for (const double value : d) {
    if (value != 0) sorted.push_back(value);
  }
  std::sort(sorted.begin(), sorted.end(),
            [](double a, double b) { return std::abs(a) < std::abs(b); });
  const std::size_t before = zeros == Zeros::pratt ? d.size() - sorted.size() : 0;
  std::vector<SignedRank> ranks;
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
    while (end < sorted.size() && std::abs(sorted[end]) == std::abs(sorted[begin])) ++end;
    const auto doubled = static_cast<std::int64_t>(2 * before + begin + 1 + end);
    for (std::size_t i = begin; i < end; ++i) ranks.push_back({doubled, sorted[i] > 0});
    const auto ties = static_cast<double>(end - begin);
    test.tie_sum += ties * ties * ties - ties;
    test.n_tied += end - begin > 1 ? static_cast<int>(end - begin) : 0;
  }
  return ranks;
}

Tails two_sided(double greater, double less) {
  return {std::min(1.0, 2 * std::min(greater, less)), greater, less};
}

// The small tail is summed by itself; 1 - p only ever makes the large one.
Tails exact_tails(const std::vector<SignedRank>& ranks, std::int64_t plus, std::int64_t total) {
  std::vector<std::int64_t> doubled;
  for (const SignedRank& r : ranks) doubled.push_back(r.doubled_rank);
  const std::int64_t low = std::min(plus, total - plus);
  const auto [below, at] = sign_flip_tail(std::move(doubled), low);
  const double small = below + at;
  const double large = 1 - below;
  return plus == low ? two_sided(large, small) : two_sided(small, large);
}

double upper_tail(double z) { return std::erfc(z / std::sqrt(2.0)) / 2; }

void add_normal(SignedRankTest& test) {
  const double sd = std::sqrt(test.variance);
  const double deviation = test.w_plus - test.mean;
  const double shrunk = std::max(std::abs(deviation) - 0.5, 0.0);
  test.z = deviation / sd;
  test.z_corrected = deviation == 0 ? 0.0 : std::copysign(shrunk, deviation) / sd;
  test.normal = Tails{2 * upper_tail(std::abs(*test.z)), upper_tail(*test.z), upper_tail(-*test.z)};
  test.normal_corrected =
      Tails{2 * upper_tail(std::abs(*test.z_corrected)), upper_tail((deviation - 0.5) / sd),
            upper_tail(-(deviation + 0.5) / sd)};
}

}  // namespace

SignedRankTest wilcoxon(const std::vector<double>& d, Zeros zeros, std::size_t exact_up_to) {
  SignedRankTest test;
  const std::vector<SignedRank> ranks = rank(d, zeros, test);
  std::int64_t plus = 0;
  std::int64_t total = 0;
  for (const SignedRank& r : ranks) {
    const auto doubled = static_cast<double>(r.doubled_rank);
    total += r.doubled_rank;
    plus += r.positive ? r.doubled_rank : 0;
    test.n_positive += r.positive ? 1 : 0;
    test.variance += doubled * doubled / 16;
  }
  test.n = static_cast<int>(d.size());
  test.n_zero = static_cast<int>(d.size() - ranks.size());
  test.n_negative = test.n - test.n_zero - test.n_positive;
  test.w_plus = static_cast<double>(plus) / 2;
  test.w_minus = static_cast<double>(total - plus) / 2;
  test.mean = static_cast<double>(total) / 4;
  if (ranks.size() <= std::min(exact_up_to, sign_flips_limit))
    test.exact = exact_tails(ranks, plus, total);
  if (total > 0) {
    add_normal(test);
    test.rank_biserial = (test.w_plus - test.w_minus) / (test.w_plus + test.w_minus);
  }
  return test;
}

}  // namespace promenade::analysis
