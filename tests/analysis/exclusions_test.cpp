#include "analysis/exclusions.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

TEST(Exclusions, AreReadAsTheyWereWritten) {
  const std::vector<Exclusion> written = {{"P1", "late, \"very\"", 0, "r1", "2026-11-29"},
                                          {"P2", "", 0, "", ""}};
  const auto read = parse_exclusions("x.csv", exclusions_csv(written));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].code, "P1");
  EXPECT_EQ(read[0].reason, written[0].reason);
  EXPECT_EQ(read[0].rule, "r1");
  EXPECT_EQ(read[0].date, "2026-11-29");
  EXPECT_EQ(read[1].code, "P2");
}

}  // namespace
}  // namespace promenade::analysis
