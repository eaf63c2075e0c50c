#include "analysis/statistics/row_permutations.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>

namespace promenade::analysis {
namespace {

using Rows = std::vector<std::vector<int>>;

// Three conditions; those that are not there score nothing and stay where they are.
std::vector<std::vector<int>> orders_of(const std::vector<int>& row) {
  std::vector<std::size_t> order(row.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<std::vector<int>> orders;
  do {
    std::vector<int> scores(row_permutations_conditions, 0);
    for (std::size_t i = 0; i < order.size(); ++i) scores[i] = row[order[i]];
    orders.push_back(std::move(scores));
  } while (std::next_permutation(order.begin(), order.end()));
  return orders;
}

std::int64_t sum_of(const std::vector<int>& row) {
  return std::accumulate(row.begin(), row.end(), std::int64_t{0});
}

std::int64_t observed(const Rows& scores) {
  std::int64_t squares = 0;
  for (std::size_t column = 0; column < scores[0].size(); ++column) {
    std::int64_t total = 0;
    for (const std::vector<int>& row : scores) total += row[column];
    squares += total * total;
  }
  return squares;
}

// Probabilities of the totals of the first two columns, which leave the third.
class Totals {
 public:
  explicit Totals(std::size_t largest) : side_(largest + 1), probability_(side_ * side_, 0.0) {
    probability_[0] = 1;
  }

  void add(const std::vector<int>& row) {
    const auto orders = orders_of(row);
    const double share = 1 / static_cast<double>(orders.size());
    std::vector<double> next(probability_.size(), 0.0);
    for (const std::vector<int>& order : orders) {
      const auto step =
          static_cast<std::size_t>(order[0]) * side_ + static_cast<std::size_t>(order[1]);
      for (std::size_t i = 0; i + step < next.size(); ++i) {
        next[i + step] += probability_[i] * share;
      }
    }
    probability_.swap(next);
  }

  double tail(std::int64_t sum, std::int64_t least_squares) const {
    double tail = 0;
    for (std::size_t i = 0; i < probability_.size(); ++i) {
      const auto first = static_cast<std::int64_t>(i / side_);
      const auto second = static_cast<std::int64_t>(i % side_);
      const std::int64_t third = sum - first - second;
      const bool far = first * first + second * second + third * third >= least_squares;
      if (far) tail += probability_[i];
    }
    return std::min(tail, 1.0);
  }

 private:
  std::size_t side_;
  std::vector<double> probability_;
};

}  // namespace

std::optional<double> row_permutation_tail(const Rows& scores) {
  assert(!scores.empty() && !scores[0].empty() && "a test needs subjects and conditions");
  if (scores[0].size() > row_permutations_conditions) return std::nullopt;
  if (scores.size() > row_permutations_subjects) return std::nullopt;
  std::size_t largest = 0;
  std::int64_t sum = 0;
  for (const std::vector<int>& row : scores) {
    largest += static_cast<std::size_t>(*std::max_element(row.begin(), row.end()));
    sum += sum_of(row);
  }
  Totals totals(largest);
  for (const std::vector<int>& row : scores) totals.add(row);
  return totals.tail(sum, observed(scores));
}

}  // namespace promenade::analysis
