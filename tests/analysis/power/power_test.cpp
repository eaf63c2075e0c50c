#include "analysis/power/power.h"

#include <gtest/gtest.h>

#include <cmath>

namespace promenade::analysis {
namespace {

PairFinding finding(double p, double holm, double hl) { return {p, holm, hl}; }

TEST(PowerRow, CountsWhatIsFoundWithAndWithoutHolm) {
  const PowerRow row =
      power_row({finding(0.01, 0.03, 1), finding(0.05, 0.10, 4), finding(0.2, 0.4, 2), {}}, 0.05);
  EXPECT_EQ(row.holm.found, 1);
  EXPECT_EQ(row.alone.found, 2);
  EXPECT_EQ(row.holm.studies, 4);
  EXPECT_EQ(row.hl, 2);  // of the three that have one
}

TEST(PowerRow, OfNoStudiesHasNoPowerAndNoEstimate) {
  const PowerRow row = power_row({}, 0.05);
  EXPECT_EQ(row.holm.share(), 0);
  EXPECT_EQ(row.holm.standard_error(), 0);
  EXPECT_FALSE(row.hl);
}

TEST(Rate, HasTheErrorOfItsNumberOfStudies) {
  const Rate rate{160, 200};
  EXPECT_DOUBLE_EQ(rate.share(), 0.8);
  EXPECT_NEAR(rate.standard_error(), std::sqrt(0.8 * 0.2 / 200), 1e-15);
  // Solves |x/n - p| = z sqrt(p (1 - p) / n), Wilson 1927.
  const double z = 1.959963984540054;
  for (const double p : {rate.interval().lower, rate.interval().upper}) {
    EXPECT_NEAR(std::abs(0.8 - p), z * std::sqrt(p * (1 - p) / 200), 1e-12);
  }
}

TEST(AddFormulas, AgreesWithRsPowerOfThePairedTTest) {
  // power.t.test(n = 13, delta = 1, sd = sqrt(2.5), type = "paired", strict = TRUE)
  PowerRow row;
  row.participants = 13;
  add_formulas(row, {-1, 0, 1, 2, 3}, 0.05);
  EXPECT_NEAR(row.paired_t.value(), 0.5542362503, 1e-6);
  // Three of four that are not 0 are positive.
  ASSERT_TRUE(row.sign_flips);
  EXPECT_GT(*row.sign_flips, 0.05);
}

TEST(AddFormulas, SaysNothingOfDifferencesThatDoNotVary) {
  PowerRow row;
  row.participants = 13;
  add_formulas(row, {2, 2, 2}, 0.05);
  EXPECT_FALSE(row.paired_t);
  add_formulas(row, {2}, 0.05);
  EXPECT_FALSE(row.paired_t);
}

TEST(Enough, IsTheFewestPeopleWithThePowerWanted) {
  std::vector<PowerRow> rows;
  for (const int participants : {40, 20, 10}) {
    PowerRow row{"a", "b", participants, {participants, 25}, {}, {}, {}, {}};
    rows.push_back(row);
  }
  EXPECT_EQ(enough(rows, "a", "b"), 20);
  EXPECT_FALSE(enough(rows, "a", "c"));
  EXPECT_EQ(enough(rows, "a", "b", 0.3), 10);
}

}  // namespace
}  // namespace promenade::analysis
