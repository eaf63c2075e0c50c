// The window in which a path is drawn, without a window: by mouse and by keyboard.
#include "app/path_view.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "motion/problem.h"
#include "tests/app/path_bench.h"

namespace promenade::app {
namespace {

using Eigen::Vector2d;
using Eigen::Vector2f;

class PathWindow : public testing::Test {
 protected:
  explicit PathWindow(const motion::PathWalkOptions& options = {}, int width = 1280,
                      int height = 720)
      : stage_(bench::shared_walks_graph()),
        worker_(bench::shared_walks_graph(), options),
        gui_(make_palette(false), shown_words(*bench::shared_walks_graph())),
        view_({*bench::shared_walks_graph(), drawing_, worker_, stage_}, gui_, queue_,
              [this](const motion::Take& take) {
                if (disk_full_) throw OutsideError("the disk is full");
                saved_frames_ = take.frames();
              }) {
    gui_.fit(width, height);
    unsigned char* pixels = nullptr;
    int wide = 0;
    int high = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &wide, &high);
    view_.frame();
    view_.frame();
  }

  void push(const UiEvent& event) {
    queue_.push(event);
    view_.frame();
    view_.frame();
  }
  void move_to(const Vector2f& at) {
    push({.kind = UiEvent::Kind::move, .x = at.x(), .y = at.y()});
  }
  void press(int code = 0) { push({.kind = UiEvent::Kind::button, .code = code, .down = true}); }
  void release(int code = 0) { push({.kind = UiEvent::Kind::button, .code = code, .down = false}); }
  void key(int code) {
    push({.kind = UiEvent::Kind::key, .code = code, .down = true});
    push({.kind = UiEvent::Kind::key, .code = code, .down = false});
  }
  const Widget& widget(const char* kind, const std::string& target) {
    const Widget* found = view_.widgets().find(kind, target);
    if (found == nullptr) throw std::logic_error("there is no " + target);
    return *found;
  }
  void click(const std::string& target) {
    const Box box = widget("press", target).box;
    move_to({box.middle_x(), box.middle_y()});
    press();
    release();
  }
  // Where the mouse is over that place of the ground.
  Vector2f over(const Vector2d& at) {
    const Widget& plane = widget("draw", "path");
    return {plane.zero_x + plane.unit_x * static_cast<float>(at.x()),
            plane.zero_y - plane.unit_y * static_cast<float>(at.y())};
  }
  void click_at(const Vector2d& at) {
    move_to(over(at));
    press();
    release();
  }
  void drag(const Vector2d& from, const Vector2d& to) {
    move_to(over(from));
    press();
    for (int k = 1; k <= 8; ++k) move_to(over(from + k / 8.0 * (to - from)));
    release();
  }
  void tab_to(const char* kind, const std::string& target) {
    for (int k = 0; k < 20 && !view_.focus().on(kind, target); ++k) key(GLFW_KEY_TAB);
    ASSERT_TRUE(view_.focus().on(kind, target)) << target;
  }
  void wait_for_the_walk() {
    while (worker_.working()) bench::rest();
    view_.frame();
  }

  PathDrawing drawing_;
  PathStage stage_;
  PathWorker worker_;
  Gui gui_;
  InputQueue queue_;
  PathView view_;
  int saved_frames_ = 0;
  bool disk_full_ = false;
};

// A pixel is 2.5 cm.
constexpr double pixel_m = 0.026;

TEST_F(PathWindow, WalksAStrokeThatIsDrawn) {
  EXPECT_TRUE(stage_.wandering());
  drag({0, -1}, {0, 2});
  ASSERT_TRUE(drawing_.wanted());
  EXPECT_LT((drawing_.corners().front().at - Vector2d(0, -1)).norm(), pixel_m);
  EXPECT_LT((drawing_.corners().back().at - Vector2d(0, 2)).norm(), pixel_m);
  wait_for_the_walk();
  EXPECT_FALSE(stage_.wandering());
  ASSERT_TRUE(view_.walked() && view_.walked()->result);
  EXPECT_EQ(view_.words().rfind("3.0 m wanted, ", 0), 0U) << view_.words();
}

TEST_F(PathWindow, TakesCornersByClicksAndEndsWithADoubleClick) {
  click_at({0, 0});
  click_at({0, 1});
  EXPECT_TRUE(drawing_.open());
  click_at({1, 2});
  press();
  release();
  EXPECT_FALSE(drawing_.open());
  ASSERT_EQ(drawing_.corners().size(), 3U) << "the second click is no corner";
  EXPECT_LT((drawing_.corners().back().at - Vector2d(1, 2)).norm(), pixel_m);
  EXPECT_TRUE(worker_.working() || view_.walked());
}

TEST_F(PathWindow, EndsWithEnterAndTakesBackWithBackspace) {
  for (const double z : {0.0, 1.0, 2.0, 3.0}) click_at({0, z});
  key(GLFW_KEY_BACKSPACE);
  EXPECT_EQ(drawing_.corners().size(), 3U);
  key(GLFW_KEY_ENTER);
  EXPECT_FALSE(drawing_.open());
  EXPECT_NEAR(drawing_.wanted()->length, 2, 2 * pixel_m);
  key(GLFW_KEY_BACKSPACE);
  EXPECT_NEAR(drawing_.wanted()->length, 1, 2 * pixel_m) << "the path grows shorter";
}

TEST_F(PathWindow, ATremblingHandDrawsNoStroke) {
  move_to(over({0, 0}));
  press();
  move_to(over({0, 0}) + Vector2f(2, 1));
  release();
  EXPECT_TRUE(drawing_.open());
  EXPECT_EQ(drawing_.corners().size(), 1U);
}

TEST_F(PathWindow, DrawsByKeyboardAlone) {
  tab_to("draw", "path");
  key(GLFW_KEY_ENTER);
  key(GLFW_KEY_UP);
  key(GLFW_KEY_UP);
  key(GLFW_KEY_ENTER);
  key(GLFW_KEY_LEFT);
  key(GLFW_KEY_ENTER);
  EXPECT_TRUE(drawing_.open());
  key(GLFW_KEY_ENTER);
  EXPECT_FALSE(drawing_.open()) << "twice in a place is the end";
  ASSERT_EQ(drawing_.corners().size(), 3U);
  EXPECT_EQ(drawing_.corners()[1].at, Vector2d(0, 1));
  EXPECT_EQ(drawing_.corners()[2].at, Vector2d(0.5, 1)) << "to the left is +X";
}

TEST_F(PathWindow, TheGroundGoesAlongWithTheKeyboard) {
  tab_to("draw", "path");
  for (int k = 0; k < 14; ++k) key(GLFW_KEY_UP);
  EXPECT_NEAR(view_.sight().centre.y(), 2, 1e-3) << "7 m ahead, of which 5 are seen";
  key(GLFW_KEY_HOME);
  EXPECT_EQ(view_.sight(), GroundSight());
}

TEST_F(PathWindow, DrawsEachPartInTheChosenStyle) {
  click("label:happy");
  drag({0, -2}, {0, 0});
  click("label:sad");
  drag({0, 0}, {0, 2});
  const std::vector<motion::PathPart> parts = drawing_.wanted()->parts;
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0].label, "happy");
  EXPECT_EQ(parts[1].label, "sad");
  wait_for_the_walk();
  EXPECT_EQ(view_.walked()->motion->labels.front().label, "happy");
  EXPECT_EQ(view_.walked()->motion->labels.back().label, "sad");
}

TEST_F(PathWindow, GoesFromStyleToStyleByTheArrowKeys) {
  tab_to("press", "label:");
  key(GLFW_KEY_RIGHT);
  EXPECT_EQ(drawing_.chosen(), "happy");
  key(GLFW_KEY_RIGHT);
  key(GLFW_KEY_RIGHT);
  EXPECT_EQ(drawing_.chosen(), "sad") << "the last one";
  key(GLFW_KEY_TAB);
  EXPECT_FALSE(view_.focus().on("press", "label:happy")) << "Tab passes by the others";
}

TEST_F(PathWindow, ClearsAll) {
  drag({0, -1}, {0, 2});
  wait_for_the_walk();
  click("clear");
  view_.frame();
  EXPECT_TRUE(drawing_.corners().empty());
  EXPECT_TRUE(stage_.wandering());
  EXPECT_EQ(view_.walked(), nullptr);
  EXPECT_EQ(view_.words(), "");
}

TEST_F(PathWindow, WalksAgain) {
  drag({0, -1}, {0, 2});
  wait_for_the_walk();
  for (const std::int64_t at_us : {0, 400'000, 800'000}) stage_.advance(at_us);
  EXPECT_GT(stage_.seconds(), 0.5);
  click("again");
  EXPECT_EQ(stage_.seconds(), 0);
}

TEST_F(PathWindow, SavesWhatTheFigureWalks) {
  drag({0, -1}, {0, 2});
  wait_for_the_walk();
  click("save");
  EXPECT_EQ(saved_frames_, view_.walked()->motion->take.frames());
  EXPECT_EQ(view_.words(), "Saved");
  disk_full_ = true;
  click("save");
  EXPECT_EQ(view_.words(), "the disk is full");
}

TEST_F(PathWindow, HasNothingToSaveBeforeThereIsAWalk) {
  click("save");
  EXPECT_EQ(saved_frames_, 0);
}

TEST_F(PathWindow, ZoomsWithTheWheelAndMovesWithTheRightButton) {
  move_to(over({0, 0}));
  push({.kind = UiEvent::Kind::wheel, .y = 1});
  EXPECT_NEAR(view_.sight().across, 8, 1e-6);
  press(1);
  move_to(over({0, 0}) + Vector2f(50, 0));
  release(1);
  EXPECT_NEAR(view_.sight().centre.x(), 1, 0.02) << "the ground follows the hand";
  EXPECT_TRUE(drawing_.corners().empty());
}

TEST_F(PathWindow, TurnsTheFigureByDraggingIt) {
  move_to({400, 300});
  press();
  move_to({500, 300});
  release();
  EXPECT_NEAR(stage_.orbit().yaw, 0.8, 1e-5);
}

class LongSearch : public PathWindow {
 protected:
  LongSearch() : PathWindow(bench::patient(), 2560, 1440) {
    for (int k = 0; k < 8; ++k) {
      move_to(over({0, 0}));
      push({.kind = UiEvent::Kind::wheel, .y = -1});
    }
    for (int k = 0; k < 12; ++k) click_at({0, k % 2 == 0 ? -15.0 : 15.0});
    key(GLFW_KEY_ENTER);
  }
};

TEST_F(LongSearch, IsSeenAndStopped) {
  EXPECT_EQ(view_.sight().across, most_across_m);
  while (worker_.working() && view_.walked() == nullptr) view_.frame();
  EXPECT_FALSE(stage_.wandering()) << "the best so far is walked";
  ASSERT_TRUE(worker_.working());
  click("stop");
  wait_for_the_walk();
  EXPECT_EQ(view_.words().rfind("Stopped: ", 0), 0U) << view_.words();
}

}  // namespace
}  // namespace promenade::app
