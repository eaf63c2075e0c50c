// What a search for a walk along a path tells while it works, and how it is stopped.
#include <gtest/gtest.h>

#include "motion/graph/path_walk.h"
#include "tests/motion/graph/arc_graph.h"

namespace promenade::motion {
namespace {

using Told = std::function<bool(const GraphWalk&, double)>;

// Ahead, from 5 m to the left.
PathWalk walk_ahead(double metres, const Told& progress) {
  const ArcGraph toy = straight_left_right();
  Eigen::Matrix2Xd points(2, 2);
  points << 5, 5, 0, metres;
  return walk_along(toy.graph, edge_ways(toy.graph, toy.courses), GroundPath(points), {}, progress);
}

TEST(WalkAlongProgress, TellsOfWalksFromTheBeginningOfThePath) {
  double most = 0;
  walk_ahead(20, [&](const GraphWalk& walk, double share) {
    EXPECT_FALSE(walk.edges.empty());
    EXPECT_NEAR(walk.start.x0, 5, 1e-9);
    EXPECT_NEAR(walk.start.z0, 0, 1e-9);
    most = std::max(most, share);
    return true;
  });
  EXPECT_EQ(most, 1) << "and at last of a whole one";
}

TEST(WalkAlongProgress, StopsWhenItIsTold) {
  const PathWalk found = walk_ahead(1000, [](const GraphWalk&, double) { return false; });
  EXPECT_TRUE(found.stopped);
  EXPECT_LT(found.walked_m, 20);
}

TEST(WalkAlongProgress, KeepsTheBestSoFarWhenItIsStopped) {
  const PathWalk found =
      walk_ahead(1000, [](const GraphWalk&, double share) { return share < 0.1; });
  EXPECT_TRUE(found.stopped);
  EXPECT_NEAR(found.walked_m, 100, 20);
}

TEST(WalkAlongProgress, KeepsAWholeWalkWhenABetterOneIsNotAwaited) {
  bool whole = false;
  const PathWalk found = walk_ahead(20, [&](const GraphWalk&, double share) {
    if (whole) return false;
    whole = share >= 1;
    return true;
  });
  EXPECT_TRUE(whole);
  EXPECT_GE(found.walked_m, 20);
}

}  // namespace
}  // namespace promenade::motion
