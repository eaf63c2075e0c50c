#include "analysis/statistics/krippendorff_alpha.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/quiet.h"

namespace promenade::analysis {
namespace {

// Ratings as places among the values that were given.
struct Units {
  std::vector<std::vector<std::size_t>> units;  // of at least two ratings
  std::vector<double> values;                   // sorted, largest magnitude between 1/2 and 1
  std::vector<double> counts;                   // how often each was given
  std::vector<double> before;                   // how often smaller ones were
};

std::vector<std::vector<double>> pairable_units(
    const std::vector<std::vector<std::optional<double>>>& ratings) {
  std::vector<std::vector<double>> units(ratings.empty() ? 0 : ratings[0].size());
  for (const auto& rater : ratings) {
    for (std::size_t unit = 0; unit < rater.size(); ++unit) {
      if (rater[unit]) units[unit].push_back(*rater[unit]);
    }
  }
  std::erase_if(units, [](const std::vector<double>& unit) { return unit.size() < 2; });
  return units;
}

// A power of two leaves all four scales as they are and keeps squares finite.
void scale(std::vector<double>& values) {
  if (values.empty()) return;
  int exponent = 0;
  std::frexp(std::max(std::abs(values.front()), std::abs(values.back())), &exponent);
  for (double& value : values) value = std::ldexp(value, -exponent);
}

Units places_of(const std::vector<std::vector<double>>& units) {
  Units result;
  std::vector<double>& values = result.values;
  for (const auto& unit : units) values.insert(values.end(), unit.begin(), unit.end());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  result.counts.assign(values.size(), 0.0);
  for (const std::vector<double>& unit : units) {
    auto& places = result.units.emplace_back();
    for (const double value : unit) {
      const auto found = std::lower_bound(values.begin(), values.end(), value);
      places.push_back(static_cast<std::size_t>(found - values.begin()));
      ++result.counts[places.back()];
    }
  }
  double sum = 0;
  for (const double count : result.counts) {
    result.before.push_back(sum);
    sum += count;
  }
  scale(values);
  return result;
}

// squared(c, k): the squared difference of two places, c < k.
template <typename Squared>
std::optional<double> alpha_of(const Units& all, const Squared& squared) {
  double observed = 0;
  double pairable = 0;
  for (const std::vector<std::size_t>& unit : all.units) {
    double sum = 0;
    for (std::size_t i = 0; i < unit.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto [c, k] = std::minmax(unit[i], unit[j]);
        sum += c == k ? 0.0 : squared(c, k);
      }
    }
    observed += sum / static_cast<double>(unit.size() - 1);
    pairable += static_cast<double>(unit.size());
  }
  double expected = 0;
  for (std::size_t k = 0; k < all.values.size(); ++k) {
    for (std::size_t c = 0; c < k; ++c) expected += all.counts[c] * all.counts[k] * squared(c, k);
  }
  if (expected == 0) return std::nullopt;
  return if_finite(1 - (pairable - 1) * observed / expected);
}

}  // namespace

KrippendorffAlpha krippendorff_alpha(
    const std::vector<std::vector<std::optional<double>>>& ratings) {
  const Units all = places_of(pairable_units(ratings));
  const std::vector<double>& v = all.values;
  KrippendorffAlpha result;
  for (const double count : all.counts) result.pairable += static_cast<int>(count);
  result.nominal = alpha_of(all, [](std::size_t, std::size_t) { return 1.0; });
  result.ordinal = alpha_of(all, [&](std::size_t c, std::size_t k) {
    const double steps = all.before[k] + all.counts[k] / 2 - all.before[c] - all.counts[c] / 2;
    return steps * steps;
  });
  result.interval =
      alpha_of(all, [&](std::size_t c, std::size_t k) { return (v[k] - v[c]) * (v[k] - v[c]); });
  result.ratio = alpha_of(all, [&](std::size_t c, std::size_t k) {
    const double part = (v[k] - v[c]) / (v[k] + v[c]);
    return part * part;
  });
  return result;
}

}  // namespace promenade::analysis
