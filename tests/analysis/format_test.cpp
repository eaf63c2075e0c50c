#include "analysis/format.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace promenade::analysis {
namespace {

TEST(Format, WritesPAsPapersDo) {
  EXPECT_EQ(p_text(0.0421), "= .042");
  EXPECT_EQ(p_text(0.0009), "< .001");
  EXPECT_EQ(p_text(0.001), "= .001");
  EXPECT_EQ(p_text(0.9999), "= 1");
  EXPECT_EQ(p_text(1e-60), "< .001");
}

TEST(Format, HasATrueMinusButNoNegativeZero) {
  EXPECT_EQ(fixed(-1.25, 1), "−1.2");
  EXPECT_EQ(fixed(-0.04, 1), "0.0");
  EXPECT_EQ(fixed(12, 0), "12");
}

TEST(Format, ShowsMetresAsCentimetres) {
  const Measure d{"d_final", "final D", "m", "cm", 100, 1};
  EXPECT_EQ(with_unit(d, 0.0314), "3.1 cm");
  EXPECT_EQ(heading(d), "Final D (cm)");
  EXPECT_EQ(shown_interval(d, {-0.01, 0.02}), "−1.0 to 2.0");
}

TEST(Format, KeepsEveryDigitForPrograms) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 123456789.123456789, 5e-324}) {
    EXPECT_EQ(std::strtod(exact_number(value).c_str(), nullptr), value);
  }
}

}  // namespace
}  // namespace promenade::analysis
