#include "analysis/statistics/hodges_lehmann.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "analysis/statistics/median.h"
#include "analysis/statistics/sign_flips.h"

namespace promenade::analysis {
namespace {

// How far to go in from the ends, and with what probability outside of one end.
struct Cut {
  std::int64_t c = 0;  // from 1; 0: not attainable
  double tail = 0;     // P(W <= c-1)
};

Cut exact_cut(int n, double alpha) {
  std::vector<std::int64_t> ranks(static_cast<std::size_t>(n));
  std::iota(ranks.begin(), ranks.end(), std::int64_t{1});
  const std::int64_t half = std::int64_t{n} * (n + 1) / 4;
  Cut cut;
  double tail = 0;
  for (const double probability : sign_flip_distribution(std::move(ranks), half)) {
    tail += probability;
    if (2 * tail > alpha) break;
    cut = {cut.c + 1, tail};
  }
  return cut;
}

Cut normal_cut(int n, double alpha) {
  const double count = n;
  const double mean = count * (count + 1) / 4;
  const double sd = std::sqrt(count * (count + 1) * (2 * count + 1) / 24);
  const double z = boost::math::quantile(boost::math::normal(), alpha / 2);
  return {static_cast<std::int64_t>(std::floor(mean + z * sd)), alpha / 2};
}

// Number of ways in which the rank sum of x reaches u above its least: divided by
// the number of all choices. counts[i][u] after i of x; the values of the
// combined sample are taken in turn.
std::vector<double> rank_sum_distribution(std::size_t nx, std::size_t ny) {
  const std::size_t size = nx * ny + 1;
  std::vector<std::vector<double>> counts(nx + 1, std::vector<double>(size, 0.0));
  counts[0][0] = 1;
  for (std::size_t value = 1; value <= nx + ny; ++value) {
    for (std::size_t i = std::min(value, nx); i >= 1; --i) {
      const std::size_t above = value - i;  // how many of y lie below this one of x
      for (std::size_t u = size; u-- > above;) counts[i][u] += counts[i - 1][u - above];
    }
  }
  std::vector<double>& all = counts[nx];
  const double total = std::accumulate(all.begin(), all.end(), 0.0);
  for (double& count : all) count /= total;
  return all;
}

// All x_i - y_j, sorted.
std::vector<double> cross_differences(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> differences;
  differences.reserve(x.size() * y.size());
  for (const double a : x) {
    for (const double b : y) differences.push_back(a - b);
  }
  std::sort(differences.begin(), differences.end());
  return differences;
}

bool has_ties(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

}  // namespace

std::optional<double> hodges_lehmann(const WalshAverages& walsh) {
  const std::int64_t half = walsh.size() / 2;
  if (walsh.size() == 0) return std::nullopt;
  if (walsh.size() % 2 == 1) return walsh[half];
  return walsh[half - 1] / 2 + walsh[half] / 2;
}

std::optional<LocationInterval> hodges_lehmann_interval(const WalshAverages& walsh, int n,
                                                        double level) {
  const double alpha = 1 - level;
  const bool exact = static_cast<std::size_t>(n) <= sign_flips_limit;
  const Cut cut = exact ? exact_cut(n, alpha) : normal_cut(n, alpha);
  if (cut.c < 1 || walsh.size() == 0) return std::nullopt;
  return LocationInterval{{walsh[cut.c - 1], walsh[walsh.size() - cut.c]}, 1 - 2 * cut.tail};
}

std::optional<double> shift_estimate(const std::vector<double>& x, const std::vector<double>& y) {
  return median_of_sorted(cross_differences(x, y));
}

std::optional<Interval> shift_interval(const std::vector<double>& x, const std::vector<double>& y,
                                       double level) {
  std::vector<double> both = x;
  both.insert(both.end(), y.begin(), y.end());
  if (x.empty() || y.empty() || has_ties(std::move(both))) return std::nullopt;
  const std::vector<double> differences = cross_differences(x, y);
  std::size_t c = 0;  // the smallest u with P(U <= u) >= alpha / 2, at least 1
  double tail = 0;
  for (const double probability : rank_sum_distribution(x.size(), y.size())) {
    tail += probability;
    if (tail >= (1 - level) / 2) break;
    ++c;
  }
  c = std::max<std::size_t>(c, 1);
  return Interval{differences[c - 1], differences[differences.size() - c]};
}

}  // namespace promenade::analysis
