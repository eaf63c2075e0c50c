#include "app/commands/numbers.h"

#include <gtest/gtest.h>

#include "motion/problem.h"

namespace promenade::app {
namespace {

TEST(ANumber, IsReadWhole) {
  EXPECT_EQ(parse_number(" -1.5e-1 "), -0.15);
  EXPECT_EQ(parse_number("+2"), 2);
  for (const char* wrong : {"", " ", "1,5", "1.5x", "nan", "inf", "0x10", "1 2"}) {
    EXPECT_FALSE(parse_number(wrong)) << wrong;
  }
}

TEST(NumbersInAnOption, AreAllWrongOnesAtOnce) {
  EXPECT_EQ(parse_numbers("--at", "1,-2.5"), Eigen::Vector2d(1, -2.5));
  try {
    parse_numbers("--at", "1,x,,2");
    FAIL() << "x is no number";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

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

TEST(ACell, IsQuotedWhenItMustBe) {
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell("a,\"b\""), "\"a,\"\"b\"\"\"");
}

}  // namespace
}  // namespace promenade::app
