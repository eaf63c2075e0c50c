// Where the figure of a drawn path is at any moment.
#include "app/path_stage.h"

#include <gtest/gtest.h>

#include "motion/graph/label_walk.h"
#include "tests/app/path_bench.h"

namespace promenade::app {
namespace {

using bench::shared_walks_graph;

// Some seconds of walking, in the world of a path.
std::shared_ptr<const study::Stimulus> walk_of(std::uint64_t seed, int frames) {
  const auto graph = shared_walks_graph();
  auto made = std::make_shared<study::Stimulus>(
      study::make_stimulus("walk", graph, motion::random_walk(*graph, seed, frames)));
  made->take.poses.resize(static_cast<std::size_t>(frames));
  return made;
}

class PathFigure : public testing::Test {
 protected:
  PathFigure() { pass(0); }
  void pass(double seconds) {
    for (double left = seconds; left >= 0; left -= 0.25) {
      const double step = std::min(left, 0.25);
      now_us_ += std::llround(1e6 * step);
      stage_.advance(now_us_);
      if (left == 0) break;
    }
  }

  PathStage stage_{shared_walks_graph()};
  std::int64_t now_us_ = 0;
};

TEST_F(PathFigure, WandersUntilThereIsAPath) {
  EXPECT_TRUE(stage_.wandering());
  EXPECT_GT(stage_.motion().seconds(), 100);
  EXPECT_FALSE(stage_.parts().empty());
  stage_.walk(walk_of(1, 60), true);
  EXPECT_FALSE(stage_.wandering());
  stage_.wander();
  EXPECT_TRUE(stage_.wandering());
}

TEST_F(PathFigure, IsWhereItsWalkIs) {
  const auto walk = walk_of(1, 60);
  stage_.walk(walk, true);
  pass(1);
  const Eigen::Vector3d root = walk->take.poses[30].root;
  EXPECT_LT((stage_.place() - Eigen::Vector2d(root.x(), root.z())).norm(), 1e-6);
  EXPECT_GT(stage_.heading().y(), 0.9) << "a straight walk goes along +Z";
}

TEST_F(PathFigure, BeginsAgainAfterItsEnd) {
  const auto walk = walk_of(1, 61);
  stage_.walk(walk, true);
  pass(walk->seconds() + study::stimulus_rest_s + 0.5);
  const Eigen::Vector3d root = walk->take.poses[15].root;
  EXPECT_LT((stage_.place() - Eigen::Vector2d(root.x(), root.z())).norm(), 1e-6);
}

TEST_F(PathFigure, WaitsAtTheEndOfWhatWasFoundSoFar) {
  stage_.walk(walk_of(1, 31), false);
  pass(5);
  EXPECT_NEAR(stage_.seconds(), 1, 1e-9);
}

TEST_F(PathFigure, GoesOnWhereTheLongerWalkBeginsAlike) {
  stage_.walk(walk_of(1, 31), false);
  pass(0.75);
  stage_.walk(walk_of(1, 90), false);
  EXPECT_NEAR(stage_.seconds(), 0.75, 1e-9);
  stage_.walk(walk_of(2, 90), false);
  EXPECT_EQ(stage_.seconds(), 0) << "another walk begins";
}

TEST_F(PathFigure, WalksOnWhileASearchThatBeganAnewIsBehindIt) {
  stage_.walk(walk_of(1, 90), true);
  pass(2);
  stage_.walk(walk_of(1, 31), false);
  EXPECT_EQ(stage_.motion().take.frames(), 90);
  stage_.walk(walk_of(1, 75), false);
  EXPECT_EQ(stage_.motion().take.frames(), 75);
  EXPECT_NEAR(stage_.seconds(), 2, 1e-9);
}

TEST_F(PathFigure, IsSeenFromWhereTheCameraStands) {
  EXPECT_NEAR(stage_.to_camera().x(), -std::sin(start_yaw), 1e-6);
  stage_.orbit().yaw = -start_yaw;
  EXPECT_NEAR(stage_.to_camera().y(), 1, 1e-6) << "from ahead";
}

}  // namespace
}  // namespace promenade::app
