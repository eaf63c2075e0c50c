#include "analysis/statistics/walsh_averages.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <numeric>

namespace promenade::analysis {
namespace {

// Doubles in their order as whole numbers: neighbours differ by one, both zeros are 0.
std::int64_t key_of(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits >= 0 ? bits : std::numeric_limits<std::int64_t>::min() - bits;
}

double value_of(std::int64_t key) {
  return std::bit_cast<double>(key >= 0 ? key : std::numeric_limits<std::int64_t>::min() - key);
}

}  // namespace

// Halves first: the sum of two large numbers may overflow.
WalshAverages::WalshAverages(const std::vector<double>& d) : halves_(d) {
  for (double& value : halves_) value /= 2;
  std::sort(halves_.begin(), halves_.end());
}

std::int64_t WalshAverages::size() const {
  const auto n = static_cast<std::int64_t>(halves_.size());
  return n * (n + 1) / 2;
}

// Rounding keeps the order of sums, so that for growing i the last partner j that
// stays below never grows.
std::int64_t WalshAverages::count_up_to(double value) const {
  std::int64_t count = 0;
  std::size_t end = halves_.size();
  for (std::size_t i = 0; i < end; ++i) {
    while (end > i && halves_[i] + halves_[end - 1] > value) --end;
    count += static_cast<std::int64_t>(end - i);
  }
  return count;
}

// The smallest double that so many averages do not exceed is one of them; it is found
// by halving the range of all doubles between the ends, 64 times at most.
double WalshAverages::operator[](std::int64_t index) const {
  assert(index >= 0 && index < size() && "there is no such Walsh average");
  std::int64_t low = key_of(2 * halves_.front());
  std::int64_t high = key_of(2 * halves_.back());
  while (low < high) {
    const std::int64_t middle = std::midpoint(low, high);
    if (count_up_to(value_of(middle)) > index) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return value_of(low);
}

}  // namespace promenade::analysis
