#include "app/window/input_queue.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace promenade::app {
namespace {

class InputQueueTest : public testing::Test {
 protected:
  InputQueueTest() { ImGui::CreateContext(); }
  ~InputQueueTest() override { ImGui::DestroyContext(); }

  void push(UiEvent::Kind kind, std::int64_t t_us, bool down = false) {
    queue.push({.kind = kind, .x = 5, .y = 6, .down = down, .t_us = t_us, .uncertainty_us = 3});
  }

  InputQueue queue;
  ImGuiIO& io() { return ImGui::GetIO(); }
};

TEST_F(InputQueueTest, APressAndAReleaseNeedTwoFrames) {
  push(UiEvent::Kind::button, 10, true);
  push(UiEvent::Kind::button, 20, false);
  queue.feed(io());
  EXPECT_TRUE(io().MouseDown[0]);
  queue.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
}

TEST_F(InputQueueTest, WhatWaitsHoldsBackTheTime) {
  push(UiEvent::Kind::button, 10, true);
  push(UiEvent::Kind::button, 20, false);
  queue.feed(io());
  EXPECT_EQ(queue.settled_us(99), 20);
  queue.feed(io());
  EXPECT_EQ(queue.settled_us(99), 99);
}

TEST_F(InputQueueTest, AFrameIsCausedByItsLastEvent) {
  push(UiEvent::Kind::move, 10);
  push(UiEvent::Kind::move, 15);
  queue.feed(io());
  EXPECT_EQ(queue.t_us(), 15);
  EXPECT_EQ(queue.uncertainty_us(), 3);
  EXPECT_EQ(io().MousePos.x, 5);
}

TEST_F(InputQueueTest, APressKeepsItsTimeAndPlace) {
  push(UiEvent::Kind::move, 10);
  push(UiEvent::Kind::button, 12, true);
  queue.feed(io());
  ASSERT_EQ(queue.presses().size(), 1U);
  EXPECT_EQ(queue.presses()[0].t_us, 12);
  EXPECT_EQ(queue.presses()[0].x, 5);
  queue.feed(io());
  EXPECT_TRUE(queue.presses().empty());
}

TEST_F(InputQueueTest, WhatIsForgottenMovedThePointerAllTheSame) {
  push(UiEvent::Kind::move, 10);
  push(UiEvent::Kind::button, 12, true);
  push(UiEvent::Kind::key, 14, true);
  queue.forget_presses();
  queue.feed(io());
  EXPECT_TRUE(queue.presses().empty());
  EXPECT_TRUE(queue.empty());
  EXPECT_EQ(io().MousePos.x, 5);
}

TEST_F(InputQueueTest, AWatcherHearsOfEachEventAsItArrives) {
  std::vector<std::int64_t> heard;
  queue.watch([&](const UiEvent& event) { heard.push_back(event.t_us); });
  push(UiEvent::Kind::move, 10);
  push(UiEvent::Kind::button, 12, true);
  EXPECT_EQ(heard, (std::vector<std::int64_t>{10, 12}));
}

TEST_F(InputQueueTest, LosingTheFocusLetsEverythingGo) {
  push(UiEvent::Kind::button, 10, true);
  queue.feed(io());
  push(UiEvent::Kind::focus, 20, false);
  queue.feed(io());
  EXPECT_FALSE(io().MouseDown[0]);
}

}  // namespace
}  // namespace promenade::app
