#include "analysis/report/cells.h"

#include <gtest/gtest.h>

#include <limits>

namespace promenade::analysis {
namespace {

TEST(Cells, AreEmptyWhereThereIsNoFiniteNumber) {
  EXPECT_EQ(cell(std::numeric_limits<double>::quiet_NaN()), Cell());
  EXPECT_EQ(cell(std::numeric_limits<double>::infinity()), Cell());
  EXPECT_EQ(cell(std::optional<double>()), Cell());
  EXPECT_EQ(cell(0.5), Cell(0.5)) << "not cut to a whole number";
  EXPECT_EQ(cell("map"), Cell(std::string("map"))) << "words are not true or false";
}

TEST(Cells, BecomeObjectsWithTheColumnsAsKeys) {
  const Table table{"t", "", {"a", "b", "c"}, {{cell("x"), cell(2), Cell()}}};
  EXPECT_EQ(json_rows(table), nlohmann::json::parse(R"([{"a": "x", "b": 2, "c": null}])"));
}

TEST(Cells, ReadAsPeopleWriteThem) {
  EXPECT_EQ(p_cell(0.0421), ".042");
  EXPECT_EQ(p_cell(0.0001), "< .001");
  EXPECT_EQ(p_cell(std::nullopt), "–");
  EXPECT_EQ(rank_sum(12), "12");
  EXPECT_EQ(rank_sum(12.5), "12.5");
  EXPECT_EQ(percent_interval({0.123, 0.8}), "12 to 80 %");
}

}  // namespace
}  // namespace promenade::analysis
