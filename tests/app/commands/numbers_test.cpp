#include "app/commands/numbers.h"

#include <gtest/gtest.h>

#include "motion/problem.h"

namespace promenade::app {
namespace {

TEST(NumbersInAnOption, AreAllWrongOnesAtOnce) {
  EXPECT_EQ(parse_numbers("--at", "1,-2.5"), Eigen::Vector2d(1, -2.5));
  try {
    parse_numbers("--at", "1,x,,2");
    FAIL() << "x is no number";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

}  // namespace
}  // namespace promenade::app
