#include "analysis/omnibus.h"

#include <algorithm>
#include <cmath>

#include "analysis/item.h"

namespace promenade::analysis {
namespace {

using Values = std::vector<std::optional<double>>;  // one per person

bool any(const Values& values) {
  return std::any_of(values.begin(), values.end(), [](const auto& value) { return value; });
}

// Values a hair apart become equal to the smallest of them.
void make_ties(std::vector<std::vector<double>>& rows) {
  double largest = 0;
  for (const auto& row : rows) {
    for (const double value : row) largest = std::max(largest, std::abs(value));
  }
  for (std::vector<double>& row : rows) {
    std::vector<double> sorted = row;
    std::sort(sorted.begin(), sorted.end());
    for (double& value : row) {
      value = *std::find_if(sorted.begin(), sorted.end(),
                            [&](double other) { return value - other <= 1e-9 * largest; });
    }
  }
}

OmnibusTest test_of(const Dataset& data, int measure, int task) {
  OmnibusTest omnibus{measure, task};
  std::vector<Values> columns;
  for (int i = 0; i < size_of(data.interfaces); ++i) {
    Values values = mean_per_person(data, measure, i, task);
    if (!any(values)) continue;
    omnibus.interfaces.push_back(i);
    columns.push_back(std::move(values));
  }
  std::vector<std::vector<double>> rows;
  for (std::size_t person = 0; person < data.people.size(); ++person) {
    std::vector<double> row;
    for (const Values& column : columns) {
      if (column[person]) row.push_back(*column[person]);
    }
    if (row.size() == columns.size()) {
      rows.push_back(std::move(row));
    } else {
      omnibus.incomplete += row.empty() ? 0 : 1;
    }
  }
  omnibus.n = size_of(rows);
  make_ties(rows);
  if (columns.size() >= 3 && !rows.empty()) omnibus.test = friedman(rows);
  return omnibus;
}

}  // namespace

std::optional<double> omnibus_p(const OmnibusTest& omnibus) {
  if (!omnibus.test || !omnibus.test->chi2) return std::nullopt;
  return omnibus.test->p_exact ? omnibus.test->p_exact : omnibus.test->p_f;
}

std::vector<OmnibusTest> omnibus_tests(const Dataset& data) {
  std::vector<OmnibusTest> all;
  for (int task = 0; task < size_of(data.tasks); ++task) {
    for (int measure = 0; measure < size_of(data.measures); ++measure) {
      OmnibusTest omnibus = test_of(data, measure, task);
      if (omnibus.interfaces.size() >= 3) all.push_back(std::move(omnibus));
    }
  }
  return all;
}

}  // namespace promenade::analysis
