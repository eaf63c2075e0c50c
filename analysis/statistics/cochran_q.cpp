#include "analysis/statistics/cochran_q.h"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cassert>

#include "analysis/statistics/row_permutations.h"

namespace promenade::analysis {
namespace {

using Rows = std::vector<std::vector<bool>>;

std::vector<int> totals_of_columns(const Rows& yes) {
  std::vector<int> totals(yes[0].size(), 0);
  for (const std::vector<bool>& row : yes) {
    for (std::size_t i = 0; i < row.size(); ++i) totals[i] += row[i] ? 1 : 0;
  }
  return totals;
}

std::vector<int> totals_of_rows(const Rows& yes) {
  std::vector<int> totals;
  for (const std::vector<bool>& row : yes) {
    totals.push_back(static_cast<int>(std::count(row.begin(), row.end(), true)));
  }
  return totals;
}

// Q grows with the sum of squared column totals, all else being fixed by the rows.
std::optional<double> statistic(const std::vector<int>& columns, const std::vector<int>& rows) {
  const auto k = static_cast<double>(columns.size());
  double sum = 0;
  double squares = 0;
  double spread = 0;
  for (const double total : columns) {
    sum += total;
    squares += total * total;
  }
  for (const double total : rows) spread += total * (k - total);
  if (spread == 0) return std::nullopt;
  return (k - 1) * (k * squares - sum * sum) / spread;
}

std::vector<std::vector<int>> as_scores(const Rows& yes) {
  std::vector<std::vector<int>> scores;
  for (const std::vector<bool>& row : yes) scores.emplace_back(row.begin(), row.end());
  return scores;
}

}  // namespace

CochranTest cochran_q(const std::vector<std::vector<bool>>& yes) {
  assert(!yes.empty() && !yes[0].empty() && "a test needs subjects and conditions");
  CochranTest test;
  test.n = static_cast<int>(yes.size());
  test.k = static_cast<int>(yes[0].size());
  test.column_totals = totals_of_columns(yes);
  const std::vector<int> rows = totals_of_rows(yes);
  test.q = statistic(test.column_totals, rows);
  if (test.q) test.p = boost::math::gamma_q((test.k - 1) / 2.0, *test.q / 2);
  test.p_exact = row_permutation_tail(as_scores(yes));
  return test;
}

}  // namespace promenade::analysis
