#include "tests/input/matching.h"

#include <gtest/gtest.h>

namespace promenade::app::input {
namespace {

Injected sent(int x, std::int64_t t_us) { return {.x = x, .t_us = t_us}; }
UiEvent came(int x, std::int64_t t_us, std::int64_t uncertainty_us = 0) {
  return {.x = static_cast<double>(x), .t_us = t_us, .uncertainty_us = uncertainty_us};
}

TEST(Matching, EachEventMeetsTheOneThatWasSent) {
  const Matching all = match({sent(1, 100), sent(2, 200)}, {came(1, 130), came(2, 205)});
  EXPECT_EQ(all.lost(), 0);
  EXPECT_EQ(all.foreign, 0);
  EXPECT_EQ(all.error_us, (std::vector<std::int64_t>{30, 5}));
}

TEST(Matching, ALostEventIsCountedAndShiftsNoOther) {
  const Matching all =
      match({sent(1, 100), sent(2, 200), sent(3, 300), sent(4, 400)}, {came(1, 130), came(3, 310)});
  EXPECT_EQ(all.lost(), 2);
  EXPECT_EQ(all.error_us, (std::vector<std::int64_t>{30, 10}));
}

TEST(Matching, AnEventOutOfOrderIsForeign) {
  const Matching all = match({sent(1, 100), sent(2, 200)}, {came(2, 205), came(1, 210)});
  EXPECT_EQ(all.foreign, 1);
  EXPECT_EQ(all.lost(), 1);
}

TEST(Matching, PressesAndReleasesAreNotMixedUp) {
  const Injected press{.kind = Injected::Kind::button, .down = true, .t_us = 7};
  const Matching all = match({press}, {{.kind = UiEvent::Kind::button, .down = false, .t_us = 9},
                                       {.kind = UiEvent::Kind::button, .down = true, .t_us = 9}});
  EXPECT_EQ(all.foreign, 1);
  EXPECT_EQ(all.error_us, std::vector<std::int64_t>{2});
}

TEST(Matching, TheTrueTimeIsWithinTheUncertaintyOrNot) {
  const Matching all = match({sent(1, 100), sent(2, 200)}, {came(1, 130, 30), came(2, 230, 10)});
  EXPECT_EQ(all.within(), 1);
  EXPECT_EQ(all.within(20), 2);
}

}  // namespace
}  // namespace promenade::app::input
