#include "analysis/statistics/friedman.h"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cassert>
#include <cmath>
#include <numeric>

#include "analysis/statistics/p_adjust.h"
#include "analysis/statistics/row_permutations.h"

namespace promenade::analysis {
namespace {

using Ranks = std::vector<std::vector<int>>;  // doubled, so that midranks are whole

std::vector<int> doubled_ranks(const std::vector<double>& row) {
  std::vector<int> ranks;
  for (const double value : row) {
    const auto below =
        std::count_if(row.begin(), row.end(), [&](double other) { return other < value; });
    const auto same = std::count(row.begin(), row.end(), value);
    ranks.push_back(static_cast<int>(2 * below + same + 1));
  }
  return ranks;
}

std::vector<double> means_of(const Ranks& ranks) {
  std::vector<double> means(ranks[0].size(), 0.0);
  for (const std::vector<int>& row : ranks) {
    for (std::size_t i = 0; i < row.size(); ++i) means[i] += row[i];
  }
  for (double& mean : means) mean /= 2 * static_cast<double>(ranks.size());
  return means;
}

// Squared deviations of the doubled ranks of all subjects from their mean, k + 1.
double spread_of(const Ranks& ranks) {
  double spread = 0;
  for (const std::vector<int>& row : ranks) {
    const double mean = static_cast<double>(row.size()) + 1;
    for (const double rank : row) spread += (rank - mean) * (rank - mean);
  }
  return spread;
}

// Column totals of doubled ranks are whole numbers, so that W = 1 is seen exactly.
void add_statistics(FriedmanTest& test, const Ranks& ranks) {
  const double spread = spread_of(ranks);
  if (spread == 0) return;
  const double n = test.n;
  const double k = test.k;
  double between = 0;  // squared deviations of the column totals
  for (std::size_t column = 0; column < ranks[0].size(); ++column) {
    double total = 0;
    for (const std::vector<int>& row : ranks) total += row[column];
    between += (total - n * (k + 1)) * (total - n * (k + 1));
  }
  test.chi2 = (k - 1) * between / spread;
  test.p = boost::math::gamma_q((k - 1) / 2, *test.chi2 / 2);
  test.kendall_w = between / (n * spread);
  test.p_f = 0;
  if (between >= n * spread) return;
  test.f = (n - 1) * between / (n * spread - between);
  const boost::math::fisher_f ratio(k - 1, (k - 1) * (n - 1));
  test.p_f = boost::math::cdf(boost::math::complement(ratio, *test.f));
}

void add_pairs(FriedmanTest& test) {
  const double sd = std::sqrt(test.k * (test.k + 1) / (6.0 * test.n));
  std::vector<double> p;
  for (int a = 0; a < test.k; ++a) {
    for (int b = a + 1; b < test.k; ++b) {
      RankPair pair{a, b};
      const auto& means = test.mean_ranks;
      pair.z =
          std::abs(means[static_cast<std::size_t>(a)] - means[static_cast<std::size_t>(b)]) / sd;
      pair.p_normal = std::erfc(pair.z / std::sqrt(2.0));
      pair.p_nemenyi = range_tail(pair.z * std::sqrt(2.0), test.k);
      p.push_back(pair.p_normal);
      test.pairs.push_back(pair);
    }
  }
  const std::vector<double> adjusted = adjust_holm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) test.pairs[i].p_holm = adjusted[i];
}

double normal_cdf(double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; }

}  // namespace

// k times the integral over the smallest value: its density, and all others within q above.
// The trapezoidal rule converges geometrically on a smooth function that vanishes at both
// ends.
double range_tail(double q, int k) {
  if (q <= 0) return 1;
  constexpr double step = 1.0 / 32;
  const double density = step / std::sqrt(2 * std::acos(-1.0));
  double sum = 0;
  for (int i = -320; i <= 320; ++i) {
    const double z = i * step;
    const double within = normal_cdf(z + q) - normal_cdf(z);
    sum += std::exp(-z * z / 2) * density * std::pow(within, k - 1);
  }
  return std::clamp(1 - k * sum, 0.0, 1.0);
}

FriedmanTest friedman(const std::vector<std::vector<double>>& x) {
  assert(!x.empty() && x[0].size() > 1 && "a test needs subjects and two conditions");
  Ranks ranks;
  for (const std::vector<double>& row : x) ranks.push_back(doubled_ranks(row));
  FriedmanTest test;
  test.n = static_cast<int>(x.size());
  test.k = static_cast<int>(x[0].size());
  test.mean_ranks = means_of(ranks);
  add_statistics(test, ranks);
  add_pairs(test);
  test.p_exact = row_permutation_tail(ranks);
  return test;
}

}  // namespace promenade::analysis
