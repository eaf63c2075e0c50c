#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using bench::PanelBench;

int cycle(const std::string& name) { return motion::find_cycle(bench::space().set, name); }

TEST(Weights, BeginsAtTheAverage) {
  PanelBench panel("weights");
  const Eigen::VectorXd even = Eigen::VectorXd::Constant(10, 0.1);
  EXPECT_LT((panel.weights() - even).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Weights, ADragSetsTheSliderWhereTheMouseLetsGo) {
  PanelBench panel("weights");
  panel.drag("sad", 1);
  ASSERT_FALSE(panel.log().empty());
  EXPECT_EQ(panel.log().back().kind, "slide");
  EXPECT_EQ(panel.log().back().target, "sad");
  EXPECT_EQ(panel.log().back().value, 1);
  // One slider at 1, nine at a half.
  EXPECT_NEAR(panel.weights()(cycle("sad")), 1 / 5.5, 1e-12);
}

TEST(Weights, EveryPlaceOnTheWayIsReported) {
  PanelBench panel("weights");
  panel.drag("sad", 0, 4);
  ASSERT_EQ(panel.log().size(), 4U);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_LT(panel.log()[k].value, panel.log()[k - 1].value);
}

TEST(Weights, TakingTheKnobBesideItsMiddleDoesNotMoveIt) {
  PanelBench panel("weights");
  const Widget knob = *panel.find("slide", "old");
  panel.move_to(knob.knob + 9, knob.box.middle_y());
  panel.press();
  EXPECT_TRUE(panel.log().empty());
}

TEST(Weights, APressBesideTheKnobBringsItThere) {
  PanelBench panel("weights");
  const Widget knob = *panel.find("slide", "old");
  panel.move_to(knob.at_zero + 0.25 * (knob.at_one - knob.at_zero), knob.box.middle_y());
  panel.press();
  ASSERT_EQ(panel.log().size(), 1U);
  // The mouse is on whole steps of a float of 1200 pixels: 1e-4 of 112.
  EXPECT_NEAR(panel.log()[0].value, 0.25, 1e-5);
}

TEST(Weights, MovingOneSliderLeavesTheOtherKnobs) {
  PanelBench panel("weights");
  const float before = panel.find("slide", "old")->knob;
  panel.drag("sad", 1);
  EXPECT_EQ(panel.find("slide", "old")->knob, before);
}

TEST(Weights, OnlyShowsOneStyleAlone) {
  PanelBench panel("weights");
  panel.click("only", "proud");
  EXPECT_EQ(panel.weights(), Eigen::VectorXd::Unit(10, cycle("proud")));
}

TEST(Weights, AllAtZeroShowsTheAverageAndSaysSo) {
  PanelBench panel("weights");
  panel.click("only", "proud");
  const int vertices = panel.vertices();
  panel.drag("proud", 0);
  EXPECT_EQ(panel.weights(), study::start_weights(bench::space()));
  EXPECT_GT(panel.vertices(), vertices + 4 * 30);  // a sentence more, four corners a letter
}

TEST(Weights, ResetBringsAllBackToTheMiddle) {
  PanelBench panel("weights");
  panel.click("only", "proud");
  panel.click("reset", "");
  EXPECT_LT((panel.weights() - study::start_weights(bench::space())).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Weights, ArrowKeysMoveTheSliderThatHasTheKeyboard) {
  PanelBench panel("weights");
  const Widget knob = *panel.find("slide", "old");
  panel.move_to(knob.knob, knob.box.middle_y());
  panel.press();
  panel.release();
  panel.key(GLFW_KEY_RIGHT);
  ASSERT_EQ(panel.log().size(), 1U);
  EXPECT_EQ(panel.log()[0].target, "old");
  EXPECT_NEAR(panel.log()[0].value, 0.51, 1e-12);
}

TEST(Weights, TenFitWithoutScrolling) {
  PanelBench panel("weights");
  for (const motion::Cycle& one : bench::space().set.cycles) {
    EXPECT_TRUE(panel.find("slide", one.name)->visible()) << one.name;
  }
}

class ManyWeights : public testing::TestWithParam<int> {};

TEST_P(ManyWeights, TheLastOneIsReachedByScrolling) {
  PanelBench panel("weights", bench::long_space(GetParam()));
  const std::string last = "a_style_with_a_long_name_" + std::to_string(99 + GetParam());
  panel.move_to(900, 300);
  for (int k = 0; k < 30; ++k) panel.wheel(-1);
  ASSERT_TRUE(panel.find("slide", last)->visible());
  EXPECT_GE(panel.find("slide", last)->box.height, 28);
  panel.click("only", last);
  EXPECT_EQ(panel.weights()(GetParam() - 1), 1);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ManyWeights, testing::Values(27, 55));

}  // namespace
}  // namespace promenade::app
