#include <gtest/gtest.h>

#include <set>

#include "tests/app/panel_bench.h"

namespace promenade::app {
namespace {

using bench::PanelBench;

int cycle(const std::string& name) { return motion::find_cycle(bench::space().set, name); }

// The example that a tile of the first page leads to.
std::string any_tile(PanelBench& panel) {
  study::Rng rng(1, 2, "test");
  return panel.type().simulate(panel.state(), rng).front().target;
}

TEST(Gallery, EightSurroundTheMiddle) {
  PanelBench panel("gallery");
  int tiles = 0;
  for (const motion::Cycle& one : bench::space().set.cycles) {
    tiles += panel.find("pick", one.name) != nullptr;
  }
  EXPECT_EQ(tiles, 8);
}

TEST(Gallery, PickingOneGoesHalfWay) {
  PanelBench panel("gallery");
  const std::string name = any_tile(panel);
  panel.click("pick", name);
  Eigen::VectorXd half = 0.5 * study::start_weights(bench::space());
  half(cycle(name)) += 0.5;
  EXPECT_LT((panel.weights() - half).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Gallery, TheStepHalvesWithEachPick) {
  PanelBench panel("gallery");
  const std::string name = any_tile(panel);
  double before = panel.weights()(cycle(name));
  for (const double step : {0.5, 0.25, 0.125}) {
    panel.click("pick", name);
    const double now = panel.weights()(cycle(name));
    // Each pick goes this share of the way that is left.
    EXPECT_NEAR(now, before + step * (1 - before), 1e-15);
    before = now;
  }
}

TEST(Gallery, ALargerStepReachesTheExampleItself) {
  PanelBench panel("gallery");
  const std::string name = any_tile(panel);
  panel.click("step", "larger");
  panel.click("pick", name);
  EXPECT_EQ(panel.weights(), Eigen::VectorXd::Unit(10, cycle(name)));
}

TEST(Gallery, AStepIsNoChangeOfTheMotion) {
  PanelBench panel("gallery");
  const Eigen::VectorXd before = panel.weights();
  EXPECT_EQ(panel.state().apply({.kind = "step", .target = "smaller"}), study::Applied::aside);
  EXPECT_EQ(panel.weights(), before);
}

TEST(Gallery, OtherDirectionsShowTheRest) {
  PanelBench panel("gallery");
  std::set<std::string> seen;
  for (int page = 0; page < 2; ++page) {
    for (const motion::Cycle& one : bench::space().set.cycles) {
      if (panel.find("pick", one.name) != nullptr) seen.insert(one.name);
    }
    panel.click("others", "");
    panel.frame();
  }
  EXPECT_EQ(seen.size(), 10U);
}

}  // namespace
}  // namespace promenade::app
