#include "study/path_csv.h"

#include <gtest/gtest.h>

#include "motion/problem.h"

namespace promenade::study {
namespace {

std::string trouble_with(std::string_view text) {
  try {
    parse_path(text, "way.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PathCsv, HoldsPointsAndTheStyleWantedFromThere) {
  const PathTable table = parse_path("z,label,x\n0,happy,0\n2.5,,1\n4,sad,-1e0\n", "way.csv");
  ASSERT_EQ(table.points.cols(), 3);
  EXPECT_EQ(table.points(0, 2), -1);
  EXPECT_EQ(table.points(1, 1), 2.5);
  EXPECT_EQ(table.labels, (std::vector<std::string>{"happy", "", "sad"}));
}

TEST(PathCsv, NeedsNoLabels) {
  EXPECT_EQ(parse_path("x,z\n0,0\n1,1\n", "way.csv").labels, (std::vector<std::string>{"", ""}));
}

TEST(PathCsv, BrokenTablesAreRefusedWithTheirPlaces) {
  const std::pair<const char*, const char*> broken[] = {
      {"", "way.csv: error: is empty"},
      {"x,y\n0,0\n", "way.csv:1:3: error: there is no column \"y\" in a path"},
      {"x\n0\n", "way.csv:1:1: error: there is no column \"z\""},
      {"x,z,x\n0,0,0\n", "way.csv:1:5: error: there is another column \"x\""},
      {"x,z\n0,nan\n", "way.csv:2:3: error: 'nan' is no place in metres"},
      {"x,z\n0\n", "way.csv:2:1: error: '' is no place in metres"},
      {"x,z\n1e9,0\n", "way.csv:2:1: error: '1e9' is no place in metres"},
      {"x,z\n0,0\n1,5,2,0\n", "way.csv:3:5: error: there are more cells than columns"},
      {"x,z\n0,0\n0,600\n0,0\n", "way.csv:4:1: error: the path is longer than a kilometre here"},
      {"x,z\n1;2,0\n", "way.csv:2:1: error: '1;2' is no place in metres"},
  };
  for (const auto& [text, trouble] : broken) {
    EXPECT_EQ(trouble_with(text).find(trouble), 0U) << text << "\n" << trouble_with(text);
  }
}

TEST(PathCsv, AllProblemsComeAtOnce) {
  const std::string trouble = trouble_with("x,z\na,0\n0,b\n");
  EXPECT_NE(trouble.find("'a'"), std::string::npos);
  EXPECT_NE(trouble.find("'b'"), std::string::npos);
}

}  // namespace
}  // namespace promenade::study
