#include "motion/graph/digraph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

std::vector<Arc> random_arcs(int nodes, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Arc> arcs;
  for (int i = 0; i < count; ++i) {
    arcs.push_back(
        {static_cast<int>(random.uniform() * nodes), static_cast<int>(random.uniform() * nodes)});
  }
  return arcs;
}

// reach[a][b]: a walk of no or more arcs leads from a to b (Warshall).
std::vector<std::vector<bool>> closure(int nodes, const std::vector<Arc>& arcs) {
  const auto n = static_cast<std::size_t>(nodes);
  std::vector<std::vector<bool>> reach(n, std::vector<bool>(n));
  for (std::size_t i = 0; i < n; ++i) reach[i][i] = true;
  for (const Arc& arc : arcs) {
    reach[static_cast<std::size_t>(arc.from)][static_cast<std::size_t>(arc.to)] = true;
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        if (reach[i][k] && reach[k][j]) reach[i][j] = true;
      }
    }
  }
  return reach;
}

std::vector<Arc> chain(int nodes) {
  std::vector<Arc> arcs;
  for (int i = 0; i + 1 < nodes; ++i) arcs.push_back({i, i + 1});
  return arcs;
}

int count(const std::vector<bool>& kept) {
  return static_cast<int>(std::count(kept.begin(), kept.end(), true));
}

// 5 is a dead end, 4 a sink that loops; node 0 has no arcs.
const std::vector<Arc> takes{{6, 7}, {7, 8}, {8, 3}, {3, 1}, {1, 2},
                             {2, 6}, {3, 4}, {4, 4}, {2, 5}};

TEST(Digraph, GivesTheArcsOfANodeInTheirOrder) {
  const Digraph graph(9, takes);
  ASSERT_EQ(graph.leaving(3).size(), 2u);
  EXPECT_EQ(graph.leaving(3)[0], 3);
  EXPECT_EQ(graph.leaving(3)[1], 6);
  EXPECT_EQ(graph.heads(3)[1], 4);
  EXPECT_TRUE(graph.leaving(5).empty());
  EXPECT_EQ(graph.arcs(), 9);
}

TEST(LargestComponent, LeavesDeadEndsAndSinksOut) {
  const std::vector<bool> kept = largest_component(Digraph(9, takes));
  EXPECT_EQ(kept, (std::vector<bool>{false, true, true, true, false, false, true, true, true}));
}

TEST(StrongComponents, TellSinksFromDeadEndsAndWaysBack) {
  const std::vector<int> component = strong_components(Digraph(9, takes));
  EXPECT_EQ(component[6], component[1]);
  EXPECT_NE(component[4], component[5]);
  EXPECT_LT(component[4], component[3]);  // the arc leads to the smaller number
}

TEST(DepthFirst, FollowsArcsInTheirOrder) {
  const Digraph graph(9, takes);
  EXPECT_EQ(depth_first(graph, 6, largest_component(graph)), (std::vector<int>{6, 7, 8, 3, 1, 2}));
  EXPECT_EQ(depth_first(graph, 6, std::vector<bool>(9, true)),
            (std::vector<int>{6, 7, 8, 3, 1, 2, 5, 4}));
}

TEST(DepthFirst, MeetsNothingFromANodeThatIsNotKept) {
  const Digraph graph(9, takes);
  EXPECT_TRUE(depth_first(graph, 5, largest_component(graph)).empty());
}

TEST(StrongComponents, AreWhatReachesEachOther) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const int nodes = 1 + static_cast<int>(seed % 23);
    const std::vector<Arc> arcs = random_arcs(nodes, static_cast<int>(seed % 67), seed);
    const auto reach = closure(nodes, arcs);
    const std::vector<int> component = strong_components(Digraph(nodes, arcs));
    for (std::size_t a = 0; a < component.size(); ++a) {
      for (std::size_t b = 0; b < component.size(); ++b) {
        ASSERT_EQ(component[a] == component[b], reach[a][b] && reach[b][a]) << "seed " << seed;
        ASSERT_TRUE(!reach[a][b] || component[a] >= component[b]) << "seed " << seed;
      }
    }
  }
}

TEST(StrongComponents, AreNumberedFromZeroWithoutGaps) {
  const std::vector<int> component = strong_components(Digraph(50, random_arcs(50, 60, 3)));
  const int most = *std::max_element(component.begin(), component.end());
  for (int c = 0; c <= most; ++c) EXPECT_GT(std::count(component.begin(), component.end(), c), 0);
}

TEST(LargestComponent, IsAWalkableOneOfMostNodes) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::vector<Arc> arcs = random_arcs(15, static_cast<int>(seed % 31), seed);
    const auto reach = closure(15, arcs);
    const std::vector<bool> kept = largest_component(Digraph(15, arcs));
    int most = 0;
    for (std::size_t a = 0; a < 15; ++a) {
      int together = 0;
      for (std::size_t b = 0; b < 15; ++b) together += reach[a][b] && reach[b][a];
      const bool loops = std::ranges::any_of(arcs, [&](const Arc& arc) {
        return arc.from == static_cast<int>(a) && arc.to == static_cast<int>(a);
      });
      if (together > 1 || loops) most = std::max(most, together);
    }
    EXPECT_EQ(count(kept), most) << "seed " << seed;
  }
}

TEST(LargestComponent, OfEqualsHasTheSmallestNode) {
  const std::vector<Arc> arcs{{4, 3}, {3, 4}, {2, 0}, {0, 2}, {4, 0}};
  EXPECT_EQ(largest_component(Digraph(5, arcs)),
            (std::vector<bool>{true, false, true, false, false}));
}

TEST(LargestComponent, KeepsNothingWhereNoWayCloses) {
  EXPECT_EQ(count(largest_component(Digraph(100, chain(100)))), 0);
  EXPECT_EQ(count(largest_component(Digraph(1, {}))), 0);
}

TEST(LargestComponent, KeepsASingleNodeThatLoops) {
  const std::vector<Arc> loop{{0, 0}};
  EXPECT_EQ(count(largest_component(Digraph(1, loop))), 1);
}

TEST(Digraph, MayBeEmpty) {
  const Digraph graph(0, {});
  EXPECT_EQ(graph.nodes(), 0);
  EXPECT_TRUE(strong_components(graph).empty());
  EXPECT_TRUE(largest_component(graph).empty());
}

TEST(Digraph, OfAMillionNodesInARowNeedsNoDeepStack) {
  std::vector<Arc> arcs = chain(1'000'000);
  EXPECT_EQ(strong_components(Digraph(1'000'000, arcs)).front(), 999'999);
  arcs.push_back({999'999, 0});
  const Digraph ring(1'000'000, arcs);
  EXPECT_EQ(count(largest_component(ring)), 1'000'000);
  EXPECT_EQ(depth_first(ring, 1, std::vector<bool>(1'000'000, true)).back(), 0);
}

}  // namespace
}  // namespace promenade::motion
