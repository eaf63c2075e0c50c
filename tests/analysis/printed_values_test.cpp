// What [O] 6 printed, and the convention behind it.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "analysis/statistics/wilcoxon.h"

namespace promenade::analysis {
namespace {

constexpr int n = 13;

// D of the initial guess for targets 1 to 5: p-f, p-w, f-w.
constexpr double printed[] = {.382, .011, .807, .087, .007, .133, .002, .019,
                              .007, .004, .006, .002, .005, .003, .001};

int thousandths(double p) { return static_cast<int>(std::lround(1000 * p)); }

// n untied differences whose positive ranks sum to `w`: the largest ranks first.
std::vector<double> differences_with(int w) {
  std::vector<double> d;
  for (int rank = n; rank >= 1; --rank) {
    d.push_back(rank <= w ? rank : -rank);
    if (rank <= w) w -= rank;
  }
  return d;
}

// The p, in thousandths, of every W+ that 13 untied differences can have.
template <typename P>
std::set<int> attainable(P p) {
  std::set<int> values;
  for (int w = 0; w <= n * (n + 1) / 2; ++w) {
    const SignedRankTest test = wilcoxon(differences_with(w));
    EXPECT_EQ(test.w_plus, w);
    values.insert(thousandths(p(test)));
  }
  return values;
}

int how_many_of_the_printed(const std::set<int>& values) {
  int count = 0;
  for (const double p : printed) count += static_cast<int>(values.count(thousandths(p)));
  return count;
}

TEST(PrintedValues, AreAllAttainableByTheNormalApproximationWithoutCorrection) {
  EXPECT_EQ(how_many_of_the_printed(
                attainable([](const SignedRankTest& test) { return test.normal->two; })),
            15);
}

TEST(PrintedValues, AreRarelyAttainableByTheExactTest) {
  EXPECT_EQ(how_many_of_the_printed(
                attainable([](const SignedRankTest& test) { return test.exact->two; })),
            6);
}

TEST(PrintedValues, AreRarelyAttainableWithContinuityCorrection) {
  EXPECT_LT(how_many_of_the_printed(
                attainable([](const SignedRankTest& test) { return test.normal_corrected->two; })),
            15);
}

}  // namespace
}  // namespace promenade::analysis
