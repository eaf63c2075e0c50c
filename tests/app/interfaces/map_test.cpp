#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "app/minimap.h"
#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using bench::PanelBench;
using Eigen::Vector2d;
using Eigen::VectorXd;

const MinimapState& state_of(PanelBench& panel) {
  return static_cast<const MinimapState&>(panel.state());
}
VectorXd example(const std::string& name) {
  return VectorXd::Unit(10, motion::find_cycle(bench::space().set, name));
}
const Widget& plane(PanelBench& panel) { return *panel.find("point", "map"); }

void move_to(PanelBench& panel, const Vector2d& at) {
  const Widget& widget = plane(panel);
  panel.move_to(widget.zero_x + widget.unit_x * at.x(), widget.zero_y - widget.unit_y * at.y());
}
void click(PanelBench& panel, const Vector2d& at) {
  move_to(panel, at);
  panel.press();
  panel.release();
}
// The pointer stands on whole pixels, and a pixel has a diagonal.
double pixel(PanelBench& panel) { return 1.5 / plane(panel).unit_x; }
// Of the whole map's half side: no dot of set A is near.
Vector2d free_place(PanelBench& panel) { return state_of(panel).model().half * Vector2d(0.3, 0.4); }

TEST(Map, ADotGoesThereOnThePressAndASecondPressOffersTheRest) {
  PanelBench panel("map");
  panel.click("go", "old");
  ASSERT_EQ(panel.log().size(), 1U);
  EXPECT_EQ(panel.weights(), example("old"));
  panel.click("go", "old");
  EXPECT_EQ(panel.log().back().kind, "offer");
  EXPECT_EQ(panel.log().back().target, "old");
  EXPECT_EQ(panel.weights(), example("old"));
}

TEST(Map, AnywhereElseThePointGoesWhereThePointerIs) {
  PanelBench panel("map");
  const Vector2d wanted = free_place(panel);
  click(panel, wanted);
  ASSERT_EQ(panel.log().size(), 1U);
  EXPECT_EQ(panel.log()[0].kind, "point");
  EXPECT_LT((state_of(panel).point() - wanted).norm(), pixel(panel));
}

TEST(Map, DraggingScrubsFromADotAndOverDots) {
  PanelBench panel("map");
  const Vector2d from = state_of(panel).map().examples.col(0);
  move_to(panel, from);
  panel.press();
  const Vector2d to = state_of(panel).map().examples.col(1);
  for (int k = 1; k <= 10; ++k) move_to(panel, from + 0.1 * k * (to - from));
  panel.release();
  EXPECT_EQ(panel.log().front().kind, "go");
  EXPECT_EQ(panel.log().back().kind, "point");
  EXPECT_LT((state_of(panel).point() - to).norm(), pixel(panel));
}

TEST(Map, APressThatTremblesIsNoDrag) {
  PanelBench panel("map");
  const Widget dot = *panel.find("go", "sad");
  panel.move_to(dot.box.middle_x(), dot.box.middle_y());
  panel.press();
  panel.move_to(dot.box.middle_x() + 2, dot.box.middle_y() - 1);
  panel.release();
  EXPECT_EQ(panel.log().size(), 1U);
}

TEST(Map, OutsideItSaysThatThePointWasDrawnBack) {
  PanelBench panel("map");
  click(panel, 0.99 * state_of(panel).model().half * Vector2d(1, 1));
  EXPECT_TRUE(state_of(panel).pulled_back());
}

TEST(Map, ArrowKeysMoveThePointWhenThePlaneHasTheFocus) {
  PanelBench panel("map");
  panel.key(GLFW_KEY_RIGHT);
  EXPECT_TRUE(panel.log().empty());
  click(panel, {0, 0});
  panel.key(GLFW_KEY_RIGHT);
  const double step = state_of(panel).point().x();
  EXPECT_NEAR(step, 0.04 * state_of(panel).model().half, 1e-6 * step);
  panel.push({.kind = UiEvent::Kind::key, .code = GLFW_KEY_LEFT_SHIFT, .down = true});
  panel.key(GLFW_KEY_UP);
  EXPECT_NEAR(state_of(panel).point().y(), 0.2 * step, 1e-6 * step);
}

TEST(Map, EnterGoesToTheNearestDotAndThenOffersTheRest) {
  PanelBench panel("map");
  const Vector2d sad =
      state_of(panel).map().examples.col(motion::find_cycle(bench::space().set, "sad"));
  click(panel, 1.05 * sad);
  panel.key(GLFW_KEY_ENTER);
  EXPECT_EQ(panel.weights(), example("sad"));
  panel.key(GLFW_KEY_ENTER);
  EXPECT_EQ(panel.log().back().kind, "offer");
}

TEST(Map, EnterDrawsByLotWhereThePointIsAndSpaceGoesToADot) {
  PanelBench panel("map", bench::space(), {{"heuristic", std::string("random")}});
  click(panel, free_place(panel));
  panel.key(GLFW_KEY_RIGHT);
  const Vector2d point = state_of(panel).point();
  const VectorXd moved = panel.weights();
  panel.key(GLFW_KEY_ENTER);
  EXPECT_LT((state_of(panel).point() - point).norm(), 1e-9);
  EXPECT_GT((panel.weights() - moved).norm(), 1e-3);
  panel.key(GLFW_KEY_SPACE);
  EXPECT_EQ(panel.log().back().kind, "go");
  EXPECT_EQ(panel.weights().maxCoeff(), 1);
}

TEST(Map, TheTabKeyPassesByTheDots) {
  PanelBench panel("map");
  click(panel, free_place(panel));
  panel.key(GLFW_KEY_TAB);
  panel.key(GLFW_KEY_ENTER);
  EXPECT_EQ(panel.log().back().kind, "bookmark");
}

TEST(Map, TheWheelZoomsAboutThePointer) {
  PanelBench panel("map");
  const Widget before = plane(panel);
  const double x = before.box.x + 100;
  const double y = before.box.y + 300;
  panel.move_to(x, y);
  panel.wheel(3);
  const Widget after = plane(panel);
  EXPECT_GT(after.unit_x, 1.9f * before.unit_x);
  EXPECT_NEAR((x - after.zero_x) / after.unit_x, (x - before.zero_x) / before.unit_x, 1e-4);
  EXPECT_EQ(panel.weights(), study::start_weights(bench::space()));
  panel.click("whole", "map");
  EXPECT_FLOAT_EQ(plane(panel).unit_x, before.unit_x);
}

TEST(Map, TheRightButtonPansWhenZoomed) {
  PanelBench panel("map");
  panel.move_to(1056, 272);
  panel.wheel(4);
  const Widget before = plane(panel);
  panel.push({.kind = UiEvent::Kind::button, .code = 1, .down = true});
  panel.move_to(1086, 262);
  panel.push({.kind = UiEvent::Kind::button, .code = 1, .down = false});
  EXPECT_NEAR(plane(panel).zero_x, before.zero_x + 30, 0.1);
  EXPECT_NEAR(plane(panel).zero_y, before.zero_y - 10, 0.1);
  EXPECT_EQ(panel.log().back().kind, "pan");
}

TEST(Map, BookmarksAreKeptGoneToAndRemoved) {
  PanelBench panel("map");
  click(panel, free_place(panel));
  panel.click("bookmark", "");
  panel.click("go", "sad");
  panel.click("goto", "1");
  EXPECT_LT((state_of(panel).point() - free_place(panel)).norm(), pixel(panel));
  panel.click("goto", "1");
  EXPECT_EQ(panel.log().back().kind, "offer");
  panel.click("remove", "1");
  EXPECT_EQ(panel.find("goto", "1"), nullptr);
}

TEST(Map, ABookmarkOnTheMapIsGoneToByAPress) {
  PanelBench panel("map");
  click(panel, free_place(panel));
  panel.click("bookmark", "");
  panel.click("go", "sad");
  click(panel, free_place(panel));
  EXPECT_EQ(panel.log().back().kind, "goto");
}

TEST(Map, ABookmarkIsNamedInPlace) {
  PanelBench panel("map");
  click(panel, free_place(panel));
  panel.click("bookmark", "");
  panel.click("goto", "1");
  panel.click("edit", "1");
  panel.frame();
  panel.type("my walk");
  panel.key(GLFW_KEY_ENTER);
  EXPECT_EQ(state_of(panel).shelf().bookmarks()[0].name, "my walk");
  EXPECT_EQ(state_of(panel).shelf().edited(), 0);
  EXPECT_EQ(panel.find("rename", "1"), nullptr);
}

TEST(Map, ExamplesAreMixedWithSliders) {
  PanelBench panel("map");
  for (const char* name : {"sad", "old"}) {
    panel.click("go", name);
    panel.click("go", name);
    panel.click("mix", name);
  }
  EXPECT_TRUE(panel.weights().isApprox(0.5 * example("sad") + 0.5 * example("old"), 1e-12));
  panel.drag("old", 0, 5, "share");
  EXPECT_EQ(panel.weights(), example("sad"));
  panel.click("unmix", "sad");
  EXPECT_EQ(panel.find("unmix", "sad"), nullptr);
}

TEST(Map, TheSwitchChangesTheHeuristicInSight) {
  PanelBench panel("map", bench::space(), {{"switch", true}});
  EXPECT_EQ(panel.find("heuristic", "nobody"), nullptr);
  panel.click("heuristic", "zero");
  EXPECT_EQ(state_of(panel).heuristic(), motion::MapHeuristic::zero);
  EXPECT_GE(plane(panel).box.y, panel.find("heuristic", "zero")->box.bottom());
}

int vertices_with(const study::Parameters& changed) {
  return PanelBench("map", bench::space(), changed).vertices();
}

TEST(Map, DrawsNamesAndClustersWhenAskedTo) {
  const int vertices = vertices_with({});
  EXPECT_GT(vertices_with({{"names", std::string("always")}}), vertices + 100);
  EXPECT_GT(vertices_with({{"clusters", true}}), vertices + 100);
}

}  // namespace
}  // namespace promenade::app
