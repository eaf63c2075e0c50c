#include "analysis/export/export_demographics.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/item.h"
#include "study/csv.h"

namespace promenade::analysis {
namespace {

int count_hidden(const std::vector<DemographicCell>& cells) {
  int people = 0;
  for (const DemographicCell& cell : cells) people += cell.suppressed ? size_of(cell.people) : 0;
  return people;
}

DemographicCell* smallest_shown(std::vector<DemographicCell>& cells) {
  DemographicCell* smallest = nullptr;
  for (DemographicCell& cell : cells) {
    if (cell.suppressed) continue;
    if (!smallest || cell.people.size() < smallest->people.size()) smallest = &cell;
  }
  return smallest;
}

}  // namespace

std::vector<DemographicCell> demographic_cells(const std::vector<std::vector<std::string>>& rows) {
  std::map<std::vector<std::string>, std::vector<int>> people;
  for (int i = 0; i < size_of(rows); ++i) people[item(rows, i)].push_back(i);
  std::vector<DemographicCell> cells;
  for (auto& [values, who] : people) cells.push_back({values, who, size_of(who) < smallest_cell});
  for (int hidden = count_hidden(cells); hidden > 0 && hidden < smallest_cell;
       hidden = count_hidden(cells)) {
    DemographicCell* next = smallest_shown(cells);
    if (!next) break;
    next->suppressed = true;
  }
  return cells;
}

std::string ten_years(double value) {
  const auto from = static_cast<long long>(std::floor(value / 10) * 10);
  return std::to_string(from) + "-" + std::to_string(from + 9);
}

std::string cells_csv(const std::vector<std::string>& questions,
                      const std::vector<DemographicCell>& cells) {
  std::vector<std::string> line = questions;
  line.emplace_back("people");
  std::string csv = study::csv_line(line);
  for (const DemographicCell& cell : cells) {
    if (cell.suppressed) continue;
    line = cell.values;
    line.push_back(std::to_string(cell.people.size()));
    csv += study::csv_line(line);
  }
  line.assign(questions.size(), "(suppressed)");
  line.push_back(std::to_string(count_hidden(cells)));
  return csv + study::csv_line(line);
}

}  // namespace promenade::analysis
