#include "analysis/export/export_demographics.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows people(const std::vector<std::pair<std::string, int>>& counts) {
  Rows rows;
  for (const auto& [value, count] : counts)
    rows.insert(rows.end(), static_cast<std::size_t>(count), {value});
  return rows;
}

std::vector<std::string> hidden(const Rows& rows) {
  std::vector<std::string> values;
  for (const DemographicCell& cell : demographic_cells(rows)) {
    if (cell.suppressed) values.push_back(cell.values[0]);
  }
  return values;
}

TEST(DemographicCells, OfFivePeopleAreShown) {
  EXPECT_TRUE(hidden(people({{"a", 5}, {"b", 6}})).empty());
}

TEST(DemographicCells, OfFewerAreHidden) {
  EXPECT_EQ(hidden(people({{"a", 4}, {"b", 3}, {"c", 9}})), (std::vector<std::string>{"a", "b"}));
}

TEST(DemographicCells, HideTheNextLargerOneWhenTooFewAreHidden) {
  EXPECT_EQ(hidden(people({{"a", 1}, {"b", 8}, {"c", 6}})), (std::vector<std::string>{"a", "c"}));
  EXPECT_EQ(hidden(people({{"a", 2}})), (std::vector<std::string>{"a"}));
}

TEST(DemographicCells, AreTheCrossOfAllQuestions) {
  Rows rows = people({{"a", 10}});
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(i < 5 ? "x" : "y");
  EXPECT_EQ(demographic_cells(rows).size(), 2u);
}

TEST(DemographicCells, NameNoHiddenValueInTheTable) {
  const auto cells = demographic_cells(people({{"rare", 1}, {"some", 5}, {"many", 7}}));
  EXPECT_EQ(cells_csv({"gender"}, cells), "gender,people\nmany,7\n(suppressed),6\n");
}

TEST(AnAge, BecomesAGroupOfTenYears) {
  EXPECT_EQ(ten_years(29), "20-29");
  EXPECT_EQ(ten_years(30), "30-39");
  EXPECT_EQ(ten_years(30.5), "30-39");
}

}  // namespace
}  // namespace promenade::analysis
