#include "study/csv.h"

#include <gtest/gtest.h>

namespace promenade::study {
namespace {

TEST(ATable, KeepsQuotesCommasAndLineNumbers) {
  const auto rows = parse_csv(
      "\xEF\xBB\xBF"
      "a,b\r\n\"x, \"\"y\"\"\",\"two\nlines\"\n\nc,\n");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1].cells, (std::vector<std::string>{"x, \"y\"", "two\nlines"}));
  EXPECT_EQ(rows[1].line, 2);
  EXPECT_EQ(rows[2].line, 5);
  EXPECT_EQ(rows[2].cells, (std::vector<std::string>{"c", ""}));
}

TEST(ATable, EndsHoweverBrokenItIs) {
  for (const char* text : {"", "\"", "\"a", "\r\r", ",", "a\r", "\n\n", "\"a\"b\"c", "\"\r"}) {
    EXPECT_LE(parse_csv(text).size(), 3u) << text;
  }
}

void expect_place(const CsvRow& row, std::size_t cell, int line, int column) {
  EXPECT_EQ(row.place(cell).line, line) << "of cell " << cell;
  EXPECT_EQ(row.place(cell).column, column) << "of cell " << cell;
}

TEST(ATable, KnowsWhereItsCellsAre) {
  const auto rows = parse_csv(
      "\xEF\xBB\xBF"
      "a,bc,d\n\n\"ä,\nx\",äö,y\n");
  ASSERT_EQ(rows.size(), 2u);
  expect_place(rows[0], 0, 1, 1);
  expect_place(rows[0], 2, 1, 6);
  expect_place(rows[1], 0, 3, 1);
  expect_place(rows[1], 1, 4, 4);
  expect_place(rows[1], 2, 4, 7);
  expect_place(rows[1], 9, 4, 7);
}

TEST(ACell, IsQuotedWhenItMustBe) {
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell("a,\"b\""), "\"a,\"\"b\"\"\"");
}

TEST(ALine, IsReadBackAsItsCells) {
  const std::vector<std::string> cells = {"a", "", "b \"c\", d", "two\nlines", "=1+1"};
  const auto rows = parse_csv(csv_line(cells));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].cells, cells);
}

TEST(ANumber, IsWrittenWithTheDigitsThatReadItBack) {
  EXPECT_EQ(csv_number(0.1), "0.1");
  EXPECT_EQ(csv_number(7), "7");
  for (const double value :
       {1.0 / 3, 1e-300, -4503599627370497.5, 5e-324, 1.7976931348623157e308}) {
    EXPECT_EQ(parse_number(csv_number(value)), value);
  }
}

TEST(ANumber, IsReadWhole) {
  EXPECT_EQ(parse_number(" -1.5e-1 "), -0.15);
  EXPECT_EQ(parse_number("+2"), 2);
  for (const char* wrong : {"", " ", "1,5", "1.5x", "nan", "inf", "0x10", "1 2"}) {
    EXPECT_FALSE(parse_number(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace promenade::study
