#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using bench::PanelBench;

int cycle(const std::string& name) { return motion::find_cycle(bench::space().set, name); }

TEST(Labels, AClickShowsThatStyleAtOnce) {
  PanelBench panel("labels");
  panel.click("pick", "old");
  ASSERT_EQ(panel.log().size(), 1U);
  EXPECT_EQ(panel.log()[0].kind, "pick");
  EXPECT_EQ(panel.log()[0].target, "old");
  EXPECT_EQ(panel.weights(), Eigen::VectorXd::Unit(10, cycle("old")));
}

TEST(Labels, ThePressCountsNotTheRelease) {
  PanelBench panel("labels");
  const Widget* row = panel.find("pick", "sad");
  panel.move_to(row->box.middle_x(), row->box.middle_y());
  panel.press();
  EXPECT_EQ(panel.log().size(), 1U);
}

TEST(Labels, NothingIsPickedUntilSomethingIsTouched) {
  PanelBench panel("labels");
  panel.move_to(900, 100);
  EXPECT_TRUE(panel.log().empty());
  EXPECT_EQ(panel.weights(), study::start_weights(bench::space()));
}

TEST(Labels, ArrowKeysGoThroughTheListInItsOrder) {
  PanelBench panel("labels");
  panel.key(GLFW_KEY_DOWN);
  panel.key(GLFW_KEY_DOWN);
  panel.key(GLFW_KEY_UP);
  ASSERT_EQ(panel.log().size(), 3U);
  EXPECT_EQ(panel.log()[0].target, panel.log()[2].target);
  EXPECT_LT(panel.find("pick", panel.log()[0].target)->box.y,
            panel.find("pick", panel.log()[1].target)->box.y);
}

TEST(Labels, RowsAre32PixelsAndSortedByName) {
  PanelBench panel("labels");
  const Widget* angry = panel.find("pick", "angry");
  const Widget* sad = panel.find("pick", "sad");
  EXPECT_EQ(angry->box.height, 32);
  EXPECT_LT(angry->box.y, sad->box.y);
}

TEST(Labels, ALongListScrollsToItsEnd) {
  PanelBench panel("labels", bench::long_space(55));
  const std::string last = "a_style_with_a_long_name_154";
  EXPECT_FALSE(panel.find("pick", last)->visible());
  panel.move_to(900, 300);
  for (int k = 0; k < 20; ++k) panel.wheel(-1);
  ASSERT_TRUE(panel.find("pick", last)->visible());
  panel.click("pick", last);
  EXPECT_EQ(panel.weights()(54), 1);
}

}  // namespace
}  // namespace promenade::app
