#include "motion/graph/label_walk.h"

#include <gtest/gtest.h>

#include <set>

#include "motion/graph/graph_labels.h"
#include "motion/graph/graph_walk.h"
#include "motion/problem.h"
#include "tests/motion/graph/arc_graph.h"

namespace promenade::motion {
namespace {

// A ring of nodes for each label, with a way out at one node of each: plain to happy, happy to
// sad, sad to plain. 30 frames a second.
ArcGraph three_rings() {
  ArcGraph toy;
  for (const char* label : {"plain", "happy", "sad"}) {
    const int take = toy.add_take(label);
    for (int i = 0; i < 4; ++i) toy.add_node(take);
  }
  for (int node = 0; node < 12; ++node) {
    const int ring = node / 4;
    toy.add_arc(node, ring * 4 + (node + 1) % 4, 10, 0.3, 0);
    if (node % 4 == 2) toy.add_arc(node, ring * 4, 6, 0.2, 0);
    if (node % 4 == 3) toy.add_arc(node, (ring + 1) % 3 * 4, 10, 0.3, 0);
  }
  return toy;
}

TEST(RandomWalk, StaysOnTheGraphForItsFrames) {
  const MotionGraph graph = three_rings().graph;
  const std::vector<int> edges = random_walk(graph, 1, 500);
  EXPECT_TRUE(holds_together(graph, edges));
  EXPECT_GE(walk_frames(graph, edges), 500);
}

TEST(RandomWalk, IsDecidedByItsSeed) {
  const MotionGraph graph = three_rings().graph;
  EXPECT_EQ(random_walk(graph, 1, 500), random_walk(graph, 1, 500));
  EXPECT_NE(random_walk(graph, 1, 500), random_walk(graph, 2, 500));
}

TEST(RandomWalk, SeesAllOfTheGraphInTime) {
  const MotionGraph graph = three_rings().graph;
  const std::vector<int> edges = random_walk(graph, 3, 3000);
  EXPECT_EQ(std::set<int>(edges.begin(), edges.end()).size(), graph.edges.size());
}

TEST(GraphLabels, AreSoManyFramesAway) {
  const std::vector<int> to_sad = frames_before(three_rings().graph, "sad");
  EXPECT_EQ(to_sad[7], 0);   // the edge that leads to it shows it
  EXPECT_EQ(to_sad[4], 30);  // along the ring to its way out
  EXPECT_EQ(to_sad[3], 40);  // over happy
}

TEST(WalkThroughLabels, ShowsEachForItsTime) {
  const MotionGraph graph = three_rings().graph;
  const LabelWalk walk = walk_through_labels(graph, {{"plain", 4}, {"happy", 6}, {"sad", 2}}, 1);
  EXPECT_TRUE(holds_together(graph, walk.edges));
  const auto parts = labelled_parts(graph, walk.edges);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].label + parts[1].label + parts[2].label, "plainhappysad");
  EXPECT_NEAR(parts[0].to - parts[0].from, 120, 30);
  EXPECT_NEAR(parts[1].to - parts[1].from, 180, 45);
  EXPECT_LE(walk.other_label, 9);  // edges have ten frames: they seldom end to the frame
}

TEST(WalkThroughLabels, PassesThroughOthersWhereItMust) {
  const MotionGraph graph = three_rings().graph;
  const LabelWalk walk = walk_through_labels(graph, {{"plain", 3}, {"sad", 3}}, 1);
  const auto parts = labelled_parts(graph, walk.edges);
  EXPECT_EQ(parts.size(), 3u);
  EXPECT_LE(walk.other_label, 40);
}

TEST(WalkThroughLabels, IsDecidedByItsSeed) {
  const MotionGraph graph = three_rings().graph;
  const std::vector<WantedLabel> wanted{{"plain", 8}, {"happy", 8}};
  EXPECT_EQ(walk_through_labels(graph, wanted, 5).edges,
            walk_through_labels(graph, wanted, 5).edges);
  EXPECT_NE(walk_through_labels(graph, wanted, 5).edges,
            walk_through_labels(graph, wanted, 6).edges);
}

// The fewest frames of other labels of all walks that begin at a node and cover the frames.
int fewest(const MotionGraph& graph, const std::vector<std::string>& wanted, int node,
           std::size_t frame) {
  if (frame >= wanted.size()) return 0;
  int least = 1'000'000;
  for (const GraphEdge& edge : graph.edges) {
    if (edge.from != node) continue;
    int here = 0;
    for (std::size_t f = frame; f < frame + static_cast<std::size_t>(edge.frames); ++f) {
      if (f >= wanted.size() || wanted[f] != graph.label(edge)) ++here;
    }
    least = std::min(least, here + fewest(graph, wanted, edge.to,
                                          frame + static_cast<std::size_t>(edge.frames)));
  }
  return least;
}

TEST(WalkThroughLabels, IsAsGoodAsTheBestOfAllWalks) {
  const MotionGraph graph = three_rings().graph;
  for (const double seconds : {0.5, 1.1, 1.7}) {
    std::vector<std::string> wanted(static_cast<std::size_t>(std::lround(30 * seconds)), "happy");
    wanted.resize(2 * wanted.size(), "sad");
    int least = 1'000'000;
    for (int node = 0; node < 12; ++node) least = std::min(least, fewest(graph, wanted, node, 0));
    const LabelWalk walk = walk_through_labels(graph, {{"happy", seconds}, {"sad", seconds}}, 4);
    const int beyond = walk_frames(graph, walk.edges) - 1 - static_cast<int>(wanted.size());
    // A frame beyond costs half of one of another label in the search, and as much here.
    EXPECT_LE(walk.other_label, least);
    EXPECT_LE(walk.other_label + 0.5 * beyond, least);
  }
}

TEST(WalkThroughLabels, SaysWhichLabelsThereAre) {
  try {
    walk_through_labels(three_rings().graph, {{"plan", 4}}, 1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "toy: error: shows no \"plan\"; did you mean \"plain\"?; its labels are "
                 "\"happy\", \"plain\", \"sad\"");
  }
}

}  // namespace
}  // namespace promenade::motion
