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

// Three strides of a second each along one take, 0.65 m long; the pelvis sways 4 cm to either
// side, so that its own way is 4 % longer.
ArcGraph swaying() {
  ArcGraph walk;
  const int take = walk.add_take("plain");
  for (int i = 0; i < 4; ++i) walk.add_node(take);
  for (int i = 0; i < 3; ++i) {
    walk.graph.edges.push_back({i, i + 1, 30, -1});
    EdgeCourse stride{Matrix2Xd(2, 30), {}};
    for (int f = 0; f < 30; ++f) {
      stride.pelvis.col(f) << 0.04 * std::sin(2 * pi * f / 30), 0.65 * (i + f / 30.0);
    }
    walk.courses.push_back(stride);
  }
  return walk;
}

TEST(EdgeWays, DoNotTakeSwayForWayWalked) {
  const ArcGraph walk = swaying();
  EXPECT_NEAR(edge_ways(walk.graph, walk.courses)[1].metres, 0.65, 0.005 * 0.65);
}

TEST(EdgeWays, AreAsLongAsTheArcWhateverItsRadius) {
  ArcGraph toy;
  const int node = toy.add_node(toy.add_take("plain"));
  toy.add_arc(node, node, 60, 2, pi);
  EXPECT_NEAR(edge_ways(toy.graph, toy.courses).front().metres, 2, 0.001);
}

TEST(WalkAlong, WhoeverStandsStillComesToAnEnd) {
  ArcGraph toy;
  const int node = toy.add_node(toy.add_take("plain"));
  toy.add_arc(node, node, 30, 0.01, 0);
  const PathWalk found = walk(toy, straight(2));
  EXPECT_NEAR(found.frames, 2 / least_speed_m_s * 30, 1);
  EXPECT_TRUE(found.walk.edges.size() > 0 && !found.stopped);
}

TEST(WalkAlong, WithAHorizonAsLongAsThePathNoWalkFromThatStartCostsLess) {
  const ArcGraph toy = straight_left_right(0.7);
  const auto ways = edge_ways(toy.graph, toy.courses);
  const GroundPath path = circle(2, 0.4);  // 5 m: 8 edges, 3^8 walks
  PathWalkOptions options;
  options.horizon_s = 10;
  options.most_edges = 1'000'000;
  const PathWalk found = walk_along(toy.graph, ways, path, options);
  const PathObjective objective(toy.graph, ways, path, options);
  double best = 1e300;
  const std::function<void(const WalkState&)> visit = [&](const WalkState& state) {
    if (state.done) best = std::min(best, state.cost);
    for (int e = 0; e < 3 && !state.done; ++e) visit(objective.after(state, e, 15));
  };
  visit(objective.starts("").front());
  EXPECT_NEAR(found.cost_m2, best, 1e-12 * best);
}

// Two takes that go straight on and lead into each other.
ArcGraph two_styles() {
  ArcGraph toy;
  const int plain = toy.add_node(toy.add_take("plain")),
            happy = toy.add_node(toy.add_take("happy"));
  toy.add_arc(plain, plain, 15, 0.65, 0);
  toy.add_arc(plain, happy, 10, 0.4, 0);
  toy.add_arc(happy, happy, 15, 0.65, 0);
  toy.add_arc(happy, plain, 10, 0.4, 0);
  return toy;
}

TEST(WalkAlong, PartsOfThePathShowTheirStyle) {
  PathWalkOptions options;
  options.parts = {{0, 10, "plain"}, {10, 20, "happy"}};
  const ArcGraph toy = two_styles();
  const PathWalk found = walk(toy, straight(20), options);
  const auto parts = labelled_parts(toy.graph, found.walk.edges);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].label + parts[1].label, "plainhappy");
  EXPECT_LE(found.other_label, 15);
}

TEST(WalkAlong, ALabelThatNobodyShowsIsAnErrorWithAGuess) {
  PathWalkOptions options;
  options.parts = {{0, 10, "hapy"}};
  try {
    walk(two_styles(), straight(20), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"happy\""), std::string::npos);
  }
}

TEST(WalkAlong, CanBeStopped) {
  const ArcGraph toy = straight_left_right();
  const PathWalk found = walk_along(toy.graph, edge_ways(toy.graph, toy.courses), straight(30), {},
                                    [](const GraphWalk&, double) { return false; });
  EXPECT_TRUE(found.stopped);
  EXPECT_FALSE(found.walk.edges.empty());
  EXPECT_LT(found.walked_m, 30);
}

}  // namespace
}  // namespace promenade::motion
