#include "motion/graph/path_walk.h"

#include <gtest/gtest.h>

#include "motion/angles.h"
#include "motion/graph/path_objective.h"
#include "motion/problem.h"
#include "tests/motion/graph/arc_graph.h"

namespace promenade::motion {
namespace {

using Eigen::Matrix2Xd;

GroundPath straight(double metres) {
  Matrix2Xd points(2, 2);
  points << 0, 0, 0, metres;
  return GroundPath(points);
}

// To the left, from the origin, at first along +Z.
GroundPath circle(double radius, double turns = 1) {
  Matrix2Xd points(2, 400);
  for (int i = 0; i < 400; ++i) {
    const double angle = 2 * pi * turns * i / 399;
    points.col(i) << radius * (1 - std::cos(angle)), radius * std::sin(angle);
  }
  return GroundPath(points);
}

GroundPath s_curve() {
  Matrix2Xd points(2, 400);
  for (int i = 0; i < 400; ++i) points.col(i) << 1.5 * std::sin(i * 2 * pi / 399), i * 0.03;
  return GroundPath(points);
}

PathWalk walk(const ArcGraph& toy, const GroundPath& path, const PathWalkOptions& options = {}) {
  return walk_along(toy.graph, edge_ways(toy.graph, toy.courses), path, options);
}

TEST(WalkAlong, AStraightPathIsFollowedExactly) {
  const PathWalk found = walk(straight_left_right(), straight(30));
  EXPECT_LT(found.farthest_m, 1e-9);
  EXPECT_EQ(found.frames, 693);  // 30 m at 1.3 m/s
  EXPECT_GE(found.walked_m, 30);
  EXPECT_TRUE(found.complete);
}

TEST(WalkAlong, ACircleOfItsOwnTurnIsFollowedExactly) {
  const PathWalk found = walk(straight_left_right(0.65 / 3), circle(3));
  EXPECT_LT(found.rms_m, 0.05);  // it begins half a frame's turn beside the tangent
}

TEST(WalkAlong, CurvesAreFollowedByTurns) {
  EXPECT_LT(walk(straight_left_right(), circle(3)).rms_m, 0.15);
  EXPECT_LT(walk(straight_left_right(), s_curve()).rms_m, 0.15);
}

}  // namespace
}  // namespace promenade::motion
