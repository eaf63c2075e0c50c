#include "analysis/ratings/rating_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/item.h"
#include "analysis/statistics/quiet.h"

namespace promenade::analysis {
namespace {

using Row = std::vector<std::optional<double>>;

// values[rater][pair * N + motion].
struct Cells {
  int pairs = 0, motions = 0;
  std::vector<Row> values;

  Row of_pair(int rater, int pair) const {
    const auto first = item(values, rater).begin() + pair * motions;
    return {first, first + motions};
  }
};

Cells cells_of(const study::RatingsTable& table) {
  Cells cells{size_of(table.pairs), size_of(table.motions), {}};
  const auto size = table.pairs.size() * table.motions.size();
  cells.values.assign(static_cast<std::size_t>(table.raters), Row(size));
  std::vector<std::vector<int>> counts(cells.values.size(), std::vector<int>(size, 0));
  for (const motion::Rating& one : table.ratings) {
    const int cell = one.pair * cells.motions + one.motion;
    auto& value = item(item(cells.values, one.rater), cell);
    value = value.value_or(0) + one.value;
    ++item(item(counts, one.rater), cell);
  }
  for (std::size_t r = 0; r < counts.size(); ++r) {
    for (std::size_t c = 0; c < size; ++c) {
      if (counts[r][c] > 1) *cells.values[r][c] /= counts[r][c];
    }
  }
  return cells;
}

bool is_empty(const Row& row) {
  return std::none_of(row.begin(), row.end(), [](const auto& cell) { return cell.has_value(); });
}

std::vector<int> counts_of(const std::vector<Row>& rows, int motions) {
  std::vector<int> counts(static_cast<std::size_t>(motions), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) counts[i] += row[i] ? 1 : 0;
  }
  return counts;
}

void put_icc(const std::vector<Row>& rows, int motions, PairStatistics& result) {
  int missing = 0;
  for (const int count : result.ratings) missing += size_of(rows) - count;
  if (missing > 0) {
    result.no_icc = fmt::format("{} of {} ratings are missing", missing, size_of(rows) * motions);
  } else if (rows.size() < 2 || motions < 2) {
    result.no_icc = "needs two raters and two motions";
  } else {
    std::vector<std::vector<double>> x(static_cast<std::size_t>(motions));
    for (const Row& row : rows) {
      for (std::size_t i = 0; i < row.size(); ++i) x[i].push_back(*row[i]);
    }
    result.icc = icc(x);
    if (!result.icc->agreement) result.no_icc = "all ratings are the same";
  }
}

PairStatistics statistics_of_pair(const Cells& cells, int pair) {
  std::vector<Row> rows;  // of those who judged this pair at all
  for (int rater = 0; rater < size_of(cells.values); ++rater) {
    Row row = cells.of_pair(rater, pair);
    if (!is_empty(row)) rows.push_back(std::move(row));
  }
  PairStatistics result;
  result.ratings = counts_of(rows, cells.motions);
  result.alpha = krippendorff_alpha(rows);
  put_icc(rows, cells.motions, result);
  return result;
}

std::optional<double> correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const auto n = static_cast<double>(x.size());
  if (x.size() < 3) return std::nullopt;
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += x[i] / n;
    mean_y += y[i] / n;
  }
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  // What rounding leaves of a variance of zero is zero.
  if (xx <= 1e-20 * n || yy <= 1e-20 * n) return std::nullopt;
  return std::clamp(xy / std::sqrt(xx * yy), -1.0, 1.0);
}

struct Totals {
  std::vector<double> sum;
  std::vector<int> count;
};

Totals totals_of(const Cells& cells) {
  const auto size = static_cast<std::size_t>(cells.pairs * cells.motions);
  Totals totals{std::vector<double>(size, 0.0), std::vector<int>(size, 0)};
  for (const Row& row : cells.values) {
    for (std::size_t c = 0; c < size; ++c) {
      if (!row[c]) continue;
      totals.sum[c] += *row[c];
      ++totals.count[c];
    }
  }
  return totals;
}

RaterStatistics statistics_of_rater(const Row& row, const Totals& totals) {
  RaterStatistics result;
  std::vector<double> own, others;
  double sum = 0, squares = 0;
  for (std::size_t c = 0; c < row.size(); ++c) {
    if (!row[c]) continue;
    ++result.ratings;
    sum += *row[c];
    squares += *row[c] * *row[c];
    if (totals.count[c] < 2) continue;
    own.push_back(*row[c]);
    others.push_back((totals.sum[c] - *row[c]) / (totals.count[c] - 1));
  }
  result.correlation = correlation(own, others);
  const double n = result.ratings;
  if (n > 0) result.mean = sum / n;
  if (n > 1) result.deviation = std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1));
  return result;
}

}  // namespace

RatingStatistics rating_statistics(const study::RatingsTable& table) {
  const Cells cells = cells_of(table);
  RatingStatistics result;
  result.alpha = krippendorff_alpha(cells.values);
  result.motions.assign(table.motions.size(), 0);
  for (int pair = 0; pair < cells.pairs; ++pair) {
    result.pairs.push_back(statistics_of_pair(cells, pair));
    for (std::size_t i = 0; i < result.motions.size(); ++i) {
      result.motions[i] += result.pairs.back().ratings[i];
    }
  }
  const Totals totals = totals_of(cells);
  for (const Row& row : cells.values) result.raters.push_back(statistics_of_rater(row, totals));
  return result;
}

}  // namespace promenade::analysis
