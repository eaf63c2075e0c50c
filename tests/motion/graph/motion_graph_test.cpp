#include "motion/graph/motion_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/builtin.h"
#include "motion/graph/graph_file.h"
#include "motion/graph/graph_takes.h"
#include "motion/graph/graph_walk.h"
#include "motion/graph/seam_measures.h"

namespace promenade::motion {
namespace {

// Two styles that differ a little, so that there are ways between them.
std::vector<GraphTake> two_styles() {
  MotionSet set = *builtin_set("B");
  const Cycle happy = set.cycles.at(0), other = set.cycles.at(1);
  set.cycles = {happy, other};
  set.cycles[0].style = "one";
  set.cycles[1].style = "other";
  return takes_of_set(set, 30);
}

const BuiltGraph& built() {
  static const BuiltGraph graph = [] {
    MatchOptions options;
    options.threshold_m = 0.08;
    return build_graph(two_styles(), options);
  }();
  return graph;
}

TEST(MotionGraph, OfTwoWalksCanBeWalkedForever) {
  const MotionGraph& graph = built().graph;
  ASSERT_EQ(built().trouble, "");
  std::vector<bool> leaves(graph.nodes.size(), false), entered(graph.nodes.size(), false);
  for (const GraphEdge& edge : graph.edges) {
    leaves[static_cast<std::size_t>(edge.from)] = true;
    entered[static_cast<std::size_t>(edge.to)] = true;
  }
  EXPECT_EQ(std::count(leaves.begin(), leaves.end(), false), 0);
  EXPECT_EQ(std::count(entered.begin(), entered.end(), false), 0);
  EXPECT_TRUE(built().statistics.lost.empty());
}

TEST(MotionGraph, CountsWhatBecameOfEverything) {
  const GraphStatistics& s = built().statistics;
  const MotionGraph& graph = built().graph;
  EXPECT_EQ(s.refused, static_cast<int>(built().refusals.size()));
  EXPECT_GE(s.minima, s.matches);
  EXPECT_LE(s.transitions, 2 * s.matches - s.refused);
  EXPECT_EQ(s.transitions, static_cast<int>(graph.transitions.size()));
  EXPECT_EQ(s.edges, static_cast<int>(graph.edges.size()));
  EXPECT_LE(s.seconds_kept, s.frames * graph.frame_time);
}

TEST(MotionGraph, KeepsNoTransitionWhoseFeetSlide) {
  for (const GraphTransition& transition : built().graph.transitions) {
    EXPECT_LE(transition.quality.slide_m, TransitionLimits{}.most_slide_m);
    EXPECT_LE(transition.rms_m, 0.08);
  }
}

// A walk over every transition: nowhere does a joint jump more than in the takes by themselves.
TEST(MotionGraph, NoSeamOfAWalkIsRougherThanTheCaptures) {
  const MotionGraph& graph = built().graph;
  double inside = 0;
  for (const GraphTransition& transition : graph.transitions) {
    inside = std::max(inside, transition.quality.inside_gap_m);
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (graph.edges[e].transition < 0) continue;
    std::vector<int> edges = {static_cast<int>(e)};
    const auto next = std::find_if(graph.edges.begin(), graph.edges.end(), [&](const auto& edge) {
      return edge.from == graph.edges[e].to;
    });
    edges.push_back(static_cast<int>(next - graph.edges.begin()));
    const Take take = walk_take(graph, {edges, {}});
    EXPECT_LE(largest_gap(frame_gaps(take, knee_axes(take))).place_m, inside + 1e-9);
  }
}

TEST(MotionGraph, IsTheSameWhateverTheMachineDoesMeanwhile) {
  MatchOptions options;
  options.threshold_m = 0.08;
  EXPECT_EQ(to_bytes(build_graph(two_styles(), options).graph), to_bytes(built().graph));
}

TEST(MotionGraph, SaysWhyThereIsNoWalk) {
  MatchOptions options;
  options.threshold_m = 1e-9;
  std::vector<GraphTake> takes = two_styles();
  for (GraphTake& one : takes) one.take = part(one.take, 0, 20);  // no loop within
  const BuiltGraph none = build_graph(takes, options);
  EXPECT_TRUE(none.graph.nodes.empty());
  EXPECT_NE(none.trouble.find("has no two moments within 1e-09 m"), std::string::npos)
      << none.trouble;
}

TEST(MotionGraph, OfOneFrameSaysSo) {
  std::vector<GraphTake> takes = two_styles();
  for (GraphTake& one : takes) one.take = part(one.take, 0, 0);
  EXPECT_NE(build_graph(takes, {}).trouble.find("shorter than 10 frames"), std::string::npos);
}

TEST(MotionGraph, StopsWhenItIsToldTo) {
  EXPECT_THROW(build_graph(two_styles(), {}, [](const std::string&, double) { return false; }),
               OutsideError);
}

}  // namespace
}  // namespace promenade::motion
