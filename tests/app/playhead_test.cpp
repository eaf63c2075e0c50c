#include "app/playhead.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace promenade::app {
namespace {

TEST(Playhead, RunsAtItsSpeedAndStopsAtTheEnd) {
  Playhead head(3'000'000, 2);
  head.pass(500'000);
  EXPECT_EQ(head.t_us(), 1'000'000);
  head.pass(5'000'000);
  EXPECT_EQ(head.t_us(), 3'000'000);
  EXPECT_TRUE(head.at_end());
  EXPECT_FALSE(head.playing());
}

TEST(Playhead, SpacePausesGoesOnAndAtTheEndPlaysAgain) {
  Playhead head(3'000'000, 1);
  head.press(GLFW_KEY_SPACE);
  head.pass(500'000);
  EXPECT_EQ(head.t_us(), 0);
  head.press(GLFW_KEY_SPACE);
  head.pass(9'000'000);
  EXPECT_NE(head.hint().find("again"), std::string_view::npos);
  head.press(GLFW_KEY_SPACE);
  EXPECT_EQ(head.t_us(), 0);
  EXPECT_TRUE(head.playing());
}

TEST(Playhead, ArrowsGoASecondWithinTheTrial) {
  Playhead head(2'500'000, 1);
  head.press(GLFW_KEY_LEFT);
  EXPECT_EQ(head.t_us(), 0);
  head.press(GLFW_KEY_RIGHT);
  head.press(GLFW_KEY_RIGHT);
  EXPECT_EQ(head.t_us(), 2'000'000);
  head.press(GLFW_KEY_RIGHT);
  EXPECT_TRUE(head.at_end());
  head.press(GLFW_KEY_LEFT);
  EXPECT_EQ(head.t_us(), 1'500'000);
  EXPECT_FALSE(head.playing()) << "it stands where it was looked for";
}

TEST(Playhead, EscClosesAndOtherKeysDoNothing) {
  Playhead head(1'000'000, 1);
  head.press(GLFW_KEY_A);
  EXPECT_FALSE(head.closed());
  EXPECT_TRUE(head.playing());
  head.press(GLFW_KEY_ESCAPE);
  EXPECT_TRUE(head.closed());
}

}  // namespace
}  // namespace promenade::app
