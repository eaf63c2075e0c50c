#include "motion/graph/graph_file.h"

#include <gtest/gtest.h>

#include "motion/skeleton_bytes.h"
#include "tests/motion/graph/toy_graph.h"

namespace promenade::motion {
namespace {

MotionGraph kept_graph() {
  MotionGraph graph = toy_graph({20, 20}, {toy_passage({0, 12}, {1, 4}, 3, {1.5, 0.3, 1.4}, 0.02),
                                           toy_passage({1, 9}, {0, 5}, 4, {0, 1, 0})});
  graph.takes[1].sha256 = "abc";
  graph.options.quantile = 0.1;
  graph.options.labels = {{"a", "b", 0.04}};
  graph.transitions[0].quality.slide_m = 0.003;
  graph.threshold_m = 0.05;
  // As every graph that was built has them.
  for (GraphTransition& transition : graph.transitions) {
    for (Pose& pose : transition.poses) pose.root = pose.root.cast<float>().cast<double>();
  }
  return graph;
}

std::string trouble_with(const std::string& bytes) {
  try {
    graph_from_bytes(bytes, "x.graph");
  } catch (const InputError& error) {
    return to_text(error.problems().at(0));
  }
  return "";
}

// The same bytes with a checksum that fits.
std::string resealed(std::string bytes) { return sealed("PROMGRAF", 1, bytes.substr(28)); }

TEST(GraphFile, KeepsEverything) {
  const std::string bytes = to_bytes(kept_graph());
  const MotionGraph read = graph_from_bytes(bytes, "x.graph");
  EXPECT_EQ(to_bytes(read), bytes);
  EXPECT_EQ(read.options.quantile, 0.1);
  EXPECT_EQ(read.options.labels.at(0).to, "b");
  EXPECT_EQ(read.takes[1].sha256, "abc");
  EXPECT_EQ(read.transitions[0].quality.slide_m, 0.003);
  EXPECT_EQ(read.transitions[0].move.theta, 1.5);
  EXPECT_EQ(read.edges.size(), 4U);
  EXPECT_EQ(read.takes[0].take.poses[7].root, kept_graph().takes[0].take.poses[7].root);
}

TEST(GraphFile, WithoutATransitionIsStillAFile) {
  const std::string bytes = to_bytes(toy_graph({20}, {}));
  EXPECT_TRUE(graph_from_bytes(bytes, "x.graph").nodes.empty());
}

TEST(GraphFile, SaysWhatIsWrongWithOthers) {
  const std::string good = to_bytes(kept_graph());
  std::string damaged = good, newer = good;
  damaged[100] ^= 1;
  newer[8] = 9;
  EXPECT_EQ(trouble_with("PROMSET\nrest"),
            "x.graph: error: is not a motion graph; make one with `promenade graph build`");
  EXPECT_NE(trouble_with(damaged).find("is damaged"), std::string::npos);
  EXPECT_NE(trouble_with(newer).find("of version 9, this program reads 1;"), std::string::npos);
  EXPECT_NE(trouble_with(good.substr(0, 300)).find("is cut"), std::string::npos);
  EXPECT_NE(trouble_with("").find("is not a motion graph"), std::string::npos);
}

// Every byte of the content set to something else: refused, or a graph that can be written.
TEST(GraphFile, NoByteCanLeadItAstray) {
  const std::string good = to_bytes(kept_graph());
  int refused = 0;
  for (std::size_t at = 28; at < good.size(); ++at) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x7f);
    bytes = resealed(bytes);
    try {
      EXPECT_EQ(to_bytes(graph_from_bytes(bytes, "x.graph")), bytes);
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(GraphFile, AnEdgeThatDoesNotFitItsNodesIsRefused) {
  MotionGraph graph = kept_graph();
  graph.edges[0].frames = 6;
  EXPECT_NE(trouble_with(to_bytes(graph)).find("does not fit its nodes"), std::string::npos);
}

}  // namespace
}  // namespace promenade::motion
