// What a search for a walk along a path tells while it works, and how it is stopped.
#include <gtest/gtest.h>

#include "motion/graph/path_walk.h"
#include "tests/motion/graph/arc_graph.h"

namespace promenade::motion {
namespace {

PathWalk walk_ahead(double metres, const std::function<bool(const GraphWalk&, double)>& progress) {
  const ArcGraph toy = straight_left_right();
  Eigen::Matrix2Xd points(2, 2);
  points << 0, 0, 0, metres;
  return walk_along(toy.graph, edge_ways(toy.graph, toy.courses), GroundPath(points), {}, progress);
}

TEST(WalkAlongProgress, GrowsToTheEnd) {
  std::vector<double> shares;
  walk_ahead(20, [&](const GraphWalk& walk, double share) {
    EXPECT_FALSE(walk.edges.empty());
    shares.push_back(share);
    return true;
  });
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.back(), 0.6);
  EXPECT_LE(shares.back(), 1);
}

TEST(WalkAlongProgress, TellsAWalkThatLiesOnThePath) {
  walk_ahead(20, [&](const GraphWalk& walk, double) {
    EXPECT_NEAR(walk.start.x0, 0, 0.5);
    EXPECT_NEAR(walk.start.z0, 0, 0.5);
    return true;
  });
}

TEST(WalkAlongProgress, CanBeStoppedBeforeThereIsABeginning) {
  const PathWalk found = walk_ahead(1000, [](const GraphWalk&, double) { return false; });
  EXPECT_TRUE(found.stopped);
  EXPECT_LT(found.walked_m, 20) << "a horizon at most";
}

TEST(WalkAlongProgress, KeepsTheBestSoFarWhenItIsStopped) {
  const PathWalk found =
      walk_ahead(1000, [](const GraphWalk&, double share) { return share < 0.1 / 3; });
  EXPECT_TRUE(found.stopped);
  EXPECT_NEAR(found.walked_m, 100, 20);
}

}  // namespace
}  // namespace promenade::motion
