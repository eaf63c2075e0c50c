#include "motion/degrees.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

// In long double the angle and pi are known to 64 bits: a truth for 53.
void expect_near_truth(double degrees) {
  const long double x = std::remainder(static_cast<long double>(degrees), 360.0L) *
                        3.141592653589793238462643383279502884L / 180;
  const SineCosine found = sine_cosine_of_degrees(degrees);
  EXPECT_NEAR(found.sine, static_cast<double>(std::sin(x)), 2.3e-16) << degrees;
  EXPECT_NEAR(found.cosine, static_cast<double>(std::cos(x)), 2.3e-16) << degrees;
}

TEST(Degrees, HaveTheSineAndCosineOfLongDouble) {
  Random random(1);
  for (int i = 0; i < 20'000; ++i) {
    expect_near_truth(720 * random.uniform() - 360);
    expect_near_truth(1e7 * (random.uniform() - 0.5));
  }
  for (const double degrees : {1e9, -1e12, 1e300, 5e-324, 45.0, -45.0, 135.0}) {
    expect_near_truth(degrees);
  }
}

TEST(Degrees, AreExactAtQuarters) {
  for (int quarter = -400; quarter <= 400; ++quarter) {
    const SineCosine found = sine_cosine_of_degrees(90.0 * quarter);
    EXPECT_EQ(std::abs(found.sine), quarter % 2 == 0 ? 0 : 1);
    EXPECT_EQ(std::abs(found.cosine), quarter % 2 == 0 ? 1 : 0);
  }
  EXPECT_EQ(sine_cosine_of_degrees(270).sine, -1);
  EXPECT_EQ(sine_cosine_of_degrees(180).cosine, -1);
}

}  // namespace
}  // namespace promenade::motion
