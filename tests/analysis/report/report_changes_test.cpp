#include "analysis/report/report_changes.h"

#include <gtest/gtest.h>

#include "motion/problem.h"

namespace promenade::analysis {
namespace {

using Lines = std::vector<std::string>;

Lines changes(const std::string& before, const std::string& after) {
  return report_changes("report.json", before, after);
}

TEST(ReportChanges, OfTheSameBytesAreNone) {
  EXPECT_EQ(changes(R"({"a": 1})", R"({"a": 1})"), Lines());
  EXPECT_EQ(changes(R"({"a": 1})", R"({ "a": 1})"), Lines());
}

TEST(ReportChanges, NameTheValueAndWhatItWas) {
  EXPECT_EQ(changes(R"({"program": {"version": "1"}, "n": [1, 2]})",
                    R"({"program": {"version": "2"}, "n": [1, null]})"),
            Lines({R"(program.version: "1" -> "2")", "n[1]: 2 -> null"}));
}

TEST(ReportChanges, PairRowsByWhatTheyAreAbout) {
  EXPECT_EQ(
      changes(R"({"w": [{"m": "d", "a": "map", "p": 0.5}, {"m": "t", "a": "map", "p": 1}]})",
              R"({"w": [{"m": "x", "a": "map", "p": 3}, {"m": "d", "a": "map", "p": 0.25}]})"),
      Lines({"w[x map]: nothing -> 3 values", "w[d map].p: 0.5 -> 0.25",
             "w[t map]: 3 values -> nothing"}));
}

TEST(ReportChanges, PairRowsByPlaceWhereTwoAreAboutTheSame) {
  EXPECT_EQ(changes(R"([{"m": "d", "p": 1}, {"m": "d", "p": 2}])",
                    R"([{"m": "d", "p": 1}, {"m": "d", "p": 3}, {"m": "d", "p": 4}])"),
            Lines({"[1].p: 2 -> 3", "[2]: nothing -> 2 values"}));
}

TEST(ReportChanges, SayWhatIsNew) {
  EXPECT_EQ(changes(R"({"a": 1})", R"({"b": [1, 2]})"),
            Lines({"b: nothing -> 2 entries", "a: 1 -> nothing"}));
}

TEST(ReportChanges, CannotBeToldOfHalfAFile) {
  EXPECT_THROW(changes(R"({"a": )", R"({"a": 1})"), InputError);
}

}  // namespace
}  // namespace promenade::analysis
