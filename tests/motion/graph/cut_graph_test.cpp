#include "motion/graph/cut_graph.h"

#include <gtest/gtest.h>

#include "tests/motion/graph/toy_graph.h"

namespace promenade::motion {
namespace {

std::string text_of(const MotionGraph& graph, const GraphEdge& edge) {
  const auto name = [&](int n) {
    const GraphNode& node = graph.node(n);
    return graph.take(node.take).label + std::to_string(node.frame);
  };
  return name(edge.from) + (edge.transition < 0 ? "-" : "~") + name(edge.to) + ":" +
         std::to_string(edge.frames);
}

std::vector<std::string> edges_of(const MotionGraph& graph) {
  std::vector<std::string> texts;
  for (const GraphEdge& edge : graph.edges) texts.push_back(text_of(graph, edge));
  return texts;
}

using Texts = std::vector<std::string>;

TEST(CutGraph, ATakeIsCutWhereTransitionsLeaveAndEnterIt) {
  const MotionGraph graph = toy_graph({20}, {toy_passage({0, 12}, {0, 5}, 3)});
  EXPECT_EQ(edges_of(graph), (Texts{"a5-a12:7", "a12~a5:2"}));
}

TEST(CutGraph, ANodeIsMadeOnceHoweverManyTransitionsMeetThere) {
  const MotionGraph graph =
      toy_graph({20, 20}, {toy_passage({0, 12}, {1, 5}, 3), toy_passage({1, 5}, {0, 12}, 3),
                           toy_passage({0, 12}, {0, 5}, 3)});
  EXPECT_EQ(graph.nodes.size(), 3U);
}

TEST(CutGraph, TheTakeComesFirstThenTheBestTransition) {
  const MotionGraph graph = toy_graph(
      {20}, {toy_passage({0, 5}, {0, 9}, 3, {}, 0.03), toy_passage({0, 5}, {0, 12}, 3, {}, 0.01)});
  EXPECT_EQ(edges_of(graph), (Texts{"a5-a9:4", "a5~a12:2", "a5~a9:2", "a9-a12:3"}));
  EXPECT_EQ(graph.transition(graph.edges[1].transition).rms_m, 0.01);
}

// a5 and a12 lead to each other; b is a dead end.
MotionGraph with_dead_end() {
  return toy_graph({20, 20}, {toy_passage({0, 12}, {0, 5}, 3), toy_passage({0, 8}, {1, 4}, 4),
                              toy_passage({1, 9}, {1, 15}, 3)});
}

TEST(CutGraph, APartKeepsItsEdgesAndTheirTransitionsAlone) {
  MotionGraph graph = with_dead_end();
  graph = part_of(graph, largest_component(digraph_of(graph)));
  EXPECT_EQ(edges_of(graph), (Texts{"a5-a8:3", "a8-a12:4", "a12~a5:2"}));
  ASSERT_EQ(graph.transitions.size(), 1U);
  EXPECT_EQ(graph.transitions[0].frames.i, 12);
}

TEST(CutGraph, WhereATakeMerelyGoesOnNothingIsCut) {
  MotionGraph graph = with_dead_end();
  graph = part_of(graph, largest_component(digraph_of(graph)));
  join_straight_nodes(graph);
  EXPECT_EQ(edges_of(graph), (Texts{"a5-a12:7", "a12~a5:2"}));
}

TEST(CutGraph, ALabelAloneIsWhatCanBeWalkedWithIt) {
  const MotionGraph graph =
      toy_graph({20, 20}, {toy_passage({0, 12}, {0, 5}, 3), toy_passage({0, 8}, {1, 4}, 4),
                           toy_passage({1, 15}, {1, 2}, 3), toy_passage({1, 10}, {0, 6}, 4)});
  EXPECT_EQ(edges_of(part_with_labels(graph, {"a"})), (Texts{"a5-a12:7", "a12~a5:2"}));
  EXPECT_EQ(edges_of(part_with_labels(graph, {"b"})), (Texts{"b2-b15:13", "b15~b2:2"}));
  EXPECT_EQ(part_with_labels(graph, {"a", "b"}).nodes.size(), graph.nodes.size());
  EXPECT_TRUE(part_with_labels(graph, {"c"}).nodes.empty());
}

}  // namespace
}  // namespace promenade::motion
