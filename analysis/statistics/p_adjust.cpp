#include "analysis/statistics/p_adjust.h"

#include <algorithm>
#include <numeric>

namespace promenade::analysis {
namespace {

std::vector<std::size_t> ascending(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  return order;
}

// From the largest p down: the running minimum of factor(k) p_(k), k from 1.
template <typename Factor>
std::vector<double> step_up(const std::vector<double>& p, Factor factor) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> adjusted(p.size());
  double least = 1;
  for (std::size_t k = p.size(); k >= 1; --k) {
    least = std::min(least, factor(static_cast<double>(k)) * p[order[k - 1]]);
    adjusted[order[k - 1]] = least;
  }
  return adjusted;
}

}  // namespace

std::vector<double> adjust_bonferroni(std::vector<double> p) {
  const auto m = static_cast<double>(p.size());
  for (double& value : p) value = std::min(1.0, m * value);
  return p;
}

std::vector<double> adjust_holm(const std::vector<double>& p) {
  std::vector<double> adjusted(p.size());
  double largest = 0;
  auto left = static_cast<double>(p.size());
  for (const std::size_t i : ascending(p)) {
    largest = std::max(largest, std::min(1.0, left * p[i]));
    adjusted[i] = largest;
    left -= 1;
  }
  return adjusted;
}

std::vector<double> adjust_hochberg(const std::vector<double>& p) {
  const auto m = static_cast<double>(p.size());
  return step_up(p, [m](double k) { return m - k + 1; });
}

std::vector<double> adjust_bh(const std::vector<double>& p) {
  const auto m = static_cast<double>(p.size());
  return step_up(p, [m](double k) { return m / k; });
}

std::vector<double> adjust_by(const std::vector<double>& p) {
  const auto m = static_cast<double>(p.size());
  double harmonic = 0;
  for (std::size_t k = 1; k <= p.size(); ++k) harmonic += 1 / static_cast<double>(k);
  return step_up(p, [m, harmonic](double k) { return harmonic * m / k; });
}

}  // namespace promenade::analysis
