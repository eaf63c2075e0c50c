#include "analysis/statistics/bootstrap.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/statistics/median.h"
#include "analysis/statistics/quiet.h"
#include "study/rng.h"

namespace promenade::analysis {
namespace {

double mean_of(const std::vector<double>& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

// Draws places below `size`, two from each 64 random bits: the upper half of a product of 32
// bits, left out where the lower half would make some places likelier (Lemire 2019).
class Places {
 public:
  Places(std::uint64_t seed, std::size_t size)
      : rng_(seed, 0, "bootstrap"),
        size_(static_cast<std::uint32_t>(size)),
        reject_below_((0 - size_) % size_) {}

  // use(place), `size` times.
  template <typename Use>
  void draw_sample(const Use& use) {
    for (std::uint32_t i = 0; i < size_;) {
      const std::uint64_t bits = rng_.next();
      for (const std::uint64_t half : {bits & 0xffffffff, bits >> 32}) {
        const std::uint64_t product = half * size_;
        if (static_cast<std::uint32_t>(product) < reject_below_ || i == size_) continue;
        use(static_cast<std::size_t>(product >> 32));
        ++i;
      }
    }
  }

 private:
  study::Rng rng_;
  std::uint32_t size_, reject_below_;
};

// The median of sorted values, each of which was drawn so many times: no need to sort again.
double median_of_counts(const std::vector<double>& sorted,
                        const std::vector<std::uint32_t>& drawn) {
  const std::size_t n = sorted.size();
  std::size_t place = 0;
  std::size_t seen = drawn[0];
  while (seen < (n + 1) / 2) seen += drawn[++place];
  if (n % 2 == 1 || seen > n / 2) return sorted[place];
  const double lower = sorted[place];
  while (drawn[++place] == 0) {
  }
  return lower / 2 + sorted[place] / 2;
}

std::vector<double> median_replicates(std::vector<double> x, int count, Places places) {
  std::sort(x.begin(), x.end());
  std::vector<double> result;
  std::vector<std::uint32_t> drawn(x.size());
  for (int b = 0; b < count; ++b) {
    std::fill(drawn.begin(), drawn.end(), 0u);
    places.draw_sample([&](std::size_t place) { ++drawn[place]; });
    result.push_back(median_of_counts(x, drawn));
  }
  return result;
}

std::vector<double> mean_replicates(const std::vector<double>& x, int count, Places places) {
  std::vector<double> result;
  for (int b = 0; b < count; ++b) {
    double sum = 0;
    places.draw_sample([&](std::size_t place) { sum += x[place]; });
    result.push_back(sum / static_cast<double>(x.size()));
  }
  return result;
}

// As motion::quantile_of_sorted, but never out of the range of a double in between.
double quantile_of_sorted(const std::vector<double>& sorted, double p) {
  const double place = p * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= sorted.size()) return sorted.back();
  const double part = place - static_cast<double>(below);
  return (1 - part) * sorted[below] + part * sorted[below + 1];
}

double normal_quantile(double p) {
  return boost::math::quantile(boost::math::normal_distribution<double, Quiet>(), p);
}

// Replicates of a mean may miss the mean by rounding alone.
std::optional<double> bias_of(const std::vector<double>& sorted, double estimate) {
  const double largest = std::max(std::abs(sorted.front()), std::abs(sorted.back()));
  const double rounding = 1e-9 * largest;
  double below = 0;
  for (const double value : sorted) {
    const bool same = std::abs(value - estimate) <= rounding;
    below += same ? 0.5 : value < estimate ? 1.0 : 0.0;
  }
  return if_finite(normal_quantile(below / static_cast<double>(sorted.size())));
}

// The location without each value; fewer where one has none.
std::vector<double> jackknife(Location kind, const std::vector<double>& x) {
  std::vector<double> sorted = x;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> result;
  for (std::size_t left_out = 0; left_out < sorted.size(); ++left_out) {
    std::vector<double> rest = sorted;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(left_out));
    if (const auto value = location_of(kind, rest)) result.push_back(*value);
  }
  return result;
}

double largest_magnitude(const std::vector<double>& x) {
  double largest = 0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  return largest;
}

// In units of the largest value, then of the largest influence, so that cubes stay finite.
std::optional<double> acceleration_of(Location kind, const std::vector<double>& x) {
  std::vector<double> influences = jackknife(kind, x);
  const double unit = largest_magnitude(influences);
  if (influences.size() < x.size() || unit == 0) return std::nullopt;
  for (double& value : influences) value /= unit;
  const double mean = mean_of(influences);
  for (double& value : influences) value = mean - value;
  const double largest = largest_magnitude(influences);
  if (largest <= 4 * std::numeric_limits<double>::epsilon()) return std::nullopt;
  double squares = 0;
  double cubes = 0;
  for (const double value : influences) {
    const double part = value / largest;
    squares += part * part;
    cubes += part * part * part;
  }
  return if_finite(cubes / (6 * std::pow(squares, 1.5)));
}

// Nothing beyond the pole of the acceleration.
std::optional<double> bca_quantile(const BootstrapIntervals& result,
                                   const std::vector<double>& sorted, double p) {
  const double shifted = *result.bias + normal_quantile(p);
  const double stretch = 1 - *result.acceleration * shifted;
  if (stretch <= 0) return std::nullopt;
  const double z = *result.bias + shifted / stretch;
  return quantile_of_sorted(sorted, std::erfc(-z / std::sqrt(2.0)) / 2);
}

void put_bca(BootstrapIntervals& result, const std::vector<double>& sorted, double tail) {
  if (!result.bias || !result.acceleration) return;
  const auto lower = bca_quantile(result, sorted, tail);
  const auto upper = bca_quantile(result, sorted, 1 - tail);
  if (lower && upper) result.bca = Interval{*lower, *upper};
}

// F(k), k = 0..n.
std::vector<double> ideal_distribution(std::size_t n) {
  const auto half = static_cast<double>((n + 1) / 2);
  std::vector<double> result(n + 1, 1.0);
  for (std::size_t k = 0; k < n; ++k) {
    const double part = static_cast<double>(k) / static_cast<double>(n);
    result[k] = boost::math::ibeta(half, static_cast<double>(n) + 1 - half, part);
  }
  return result;
}

void put_moments(IdealMedian& result, const std::vector<double>& sorted,
                 const std::vector<double>& f) {
  double mean = 0;
  double variance = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) mean += (f[k + 1] - f[k]) * sorted[k];
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    variance += (f[k + 1] - f[k]) * (sorted[k] - mean) * (sorted[k] - mean);
  }
  result.mean = if_finite(mean);
  result.se = if_finite(std::sqrt(variance));
}

}  // namespace

std::optional<double> location_of(Location kind, const std::vector<double>& x) {
  if (x.empty()) return std::nullopt;
  return kind == Location::mean ? if_finite(mean_of(x)) : median_of(x);
}

std::vector<double> bootstrap_replicates(Location kind, const std::vector<double>& x, int count,
                                         std::uint64_t seed) {
  assert(x.size() <= std::numeric_limits<std::uint32_t>::max() && "places have 32 bits");
  if (x.empty()) return {};
  const Places places(seed, x.size());
  return kind == Location::mean ? mean_replicates(x, count, places)
                                : median_replicates(x, count, places);
}

BootstrapIntervals bootstrap_intervals(Location kind, const std::vector<double>& x,
                                       std::vector<double> replicates, double level) {
  BootstrapIntervals result;
  result.estimate = location_of(kind, x);
  result.acceleration = acceleration_of(kind, x);
  if (replicates.empty()) return result;
  std::sort(replicates.begin(), replicates.end());
  const double tail = (1 - level) / 2;
  const Interval q = {quantile_of_sorted(replicates, tail),
                      quantile_of_sorted(replicates, 1 - tail)};
  result.percentile = q;
  if (!result.estimate) return result;
  const double t = *result.estimate;
  result.basic = if_finite(Interval{2 * t - q.upper, 2 * t - q.lower});
  result.bias = bias_of(replicates, t);
  put_bca(result, replicates, tail);
  return result;
}

IdealMedian ideal_bootstrap_median(std::vector<double> x, double level) {
  assert(x.size() % 2 == 1 && "the median is one of the values");
  std::sort(x.begin(), x.end());
  const std::vector<double> f = ideal_distribution(x.size());
  const auto first = [&](double p) { return std::lower_bound(f.begin() + 1, f.end(), p); };
  const auto around = [](std::vector<double>::const_iterator k) { return Interval{k[-1], k[0]}; };
  const double tail = (1 - level) / 2;
  const auto lower = first(tail);
  const auto upper = first(1 - tail);
  IdealMedian result;
  result.lower = static_cast<int>(lower - f.begin());
  result.upper = static_cast<int>(upper - f.begin());
  result.interval = {x[static_cast<std::size_t>(result.lower - 1)],
                     x[static_cast<std::size_t>(result.upper - 1)]};
  result.around_lower = around(lower);
  result.around_upper = around(upper);
  result.margin =
      std::min({tail - result.around_lower.lower, result.around_lower.upper - tail,
                1 - tail - result.around_upper.lower, result.around_upper.upper - (1 - tail)});
  put_moments(result, x, f);
  return result;
}

}  // namespace promenade::analysis
