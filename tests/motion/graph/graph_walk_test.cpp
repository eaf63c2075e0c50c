#include "motion/graph/graph_walk.h"

#include <gtest/gtest.h>

#include "motion/angles.h"
#include "tests/motion/graph/toy_graph.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

constexpr double rounding = 1e-12;

// Two frames of a transition, then a quarter turn to the left: B's +Z is A's +X.
const PlanarMove quarter{pi / 2, 0.3, 1.4};

// a5 -> a12 along the take, a12 -> b4 by a transition, b4 -> b9 along b, b9 -> a5.
MotionGraph square() {
  return toy_graph({20, 20}, {toy_passage({0, 12}, {1, 4}, 3, quarter),
                              toy_passage({1, 9}, {0, 5}, 3, {0, 1, 0})});
}
const std::vector<int> around = {0, 1, 2, 3};

TEST(GraphWalk, IsWhatItsEdgesShow) {
  const MotionGraph graph = square();
  ASSERT_TRUE(holds_together(graph, around));
  const Take take = walk_take(graph, {around, {}});
  ASSERT_EQ(take.frames(), walk_frames(graph, around));
  ASSERT_EQ(take.frames(), 7 + 2 + 5 + 2 + 1);
  EXPECT_LT((take.poses[0].root - Vector3d(0, 1, 0.5)).norm(), rounding);
  EXPECT_LT((take.poses[8].root - Vector3d(0, 1, 1.3)).norm(), rounding);
}

TEST(GraphWalk, GoesOnWhereATransitionHasLedIt) {
  const Take take = walk_take(square(), {around, {}});
  // B's frame 4 lies at (0, 1, 0.4) in B: (0.4, 1, 0) turned, then moved.
  EXPECT_LT((take.poses[9].root - Vector3d(0.7, 1, 1.4)).norm(), rounding);
  EXPECT_LT((take.poses[10].root - take.poses[9].root - Vector3d(0.1, 0, 0)).norm(), rounding);
  EXPECT_NEAR(take.poses[10].rotations[0].angularDistance(quarter.rotation()), 0, 1e-7);
}

TEST(GraphWalk, MovesOfSeveralTransitionsAddUp) {
  const Take take = walk_take(square(), {around, {}});
  const PlanarMove both = after(quarter, {0, 1, 0});
  EXPECT_LT((take.poses.back().root - moved(both, Vector3d(0, 1, 0.5))).norm(), rounding);
}

TEST(GraphWalk, MayBeginAtTheOriginAndAhead) {
  const MotionGraph graph = square();
  const std::vector<int> edges = {2, 3, 0};
  const Take take = walk_take(graph, {edges, start_at_origin(graph, edges)});
  EXPECT_LT((take.poses[0].root - Vector3d(0, 1, 0)).norm(), rounding);
  EXPECT_LT((take.poses[5].root - Vector3d(0, 1, 0.5)).norm(), rounding);
}

TEST(GraphWalk, EdgesThatDoNotMeetAreNoWalk) {
  const MotionGraph graph = square();
  EXPECT_FALSE(holds_together(graph, {0, 2}));
  EXPECT_FALSE(holds_together(graph, {0, 7}));
  EXPECT_FALSE(holds_together(graph, {-1}));
}

TEST(GraphWalk, TellsWhichStyleIsSeenWhen) {
  const auto parts = labelled_parts(square(), around);
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[1].label, "b");
  EXPECT_EQ(parts[1].from, 7);
  EXPECT_EQ(parts[1].to, 14);
}

TEST(GraphWalk, CoursesAreTheWayOfThePelvis) {
  const MotionGraph graph = square();
  const auto courses = edge_courses(graph);
  const Take take = walk_take(graph, {around, {}});
  PlanarMove place;
  int frame = 0;
  for (const int e : around) {
    const EdgeCourse& course = courses[static_cast<std::size_t>(e)];
    for (const auto& at : course.pelvis.colwise()) {
      const Vector3d there = moved(place, Vector3d(at.x(), 1, at.y()));
      EXPECT_LT((there - take.poses[static_cast<std::size_t>(frame++)].root).norm(), rounding);
    }
    place = after(place, course.move);
  }
}

}  // namespace
}  // namespace promenade::motion
