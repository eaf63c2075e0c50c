// How far what people said about themselves can be published: only in cells of enough
// people, one cell for each combination of answers.
#pragma once

#include <string>
#include <vector>

namespace promenade::analysis {

constexpr int smallest_cell = 5;  // people

struct DemographicCell {
  std::vector<std::string> values;  // one for each question
  std::vector<int> people;          // indices
  bool suppressed = false;
};

// One row for each person, one value for each question. Cells by their values. Cells with
// fewer than `smallest_cell` people are suppressed, and the next larger ones with them until
// those who are hidden are that many, too: else they could be told by what is missing.
std::vector<DemographicCell> demographic_cells(const std::vector<std::vector<std::string>>& rows);

// An exact number of years as a group: "20-29".
std::string ten_years(double value);

// Cells that are published, and one row for all others: no value of theirs is named.
std::string cells_csv(const std::vector<std::string>& questions,
                      const std::vector<DemographicCell>& cells);

}  // namespace promenade::analysis
