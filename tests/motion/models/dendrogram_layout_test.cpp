#include "motion/models/dendrogram_layout.h"

#include <gtest/gtest.h>

namespace promenade::motion {
namespace {

// 0 and 1 merge at 1, 2 and 3 at 3, both at 10.
const Dendrogram four{4, {{0, 1, 1, 2}, {2, 3, 3, 2}, {4, 5, 10, 4}}};

TEST(DendrogramLayout, PutsTheTighterClusterFirstAndMergesBetween) {
  const Dendrogram other{4, {{2, 3, 1, 2}, {0, 1, 3, 2}, {4, 5, 10, 4}}};
  EXPECT_EQ(dendrogram_layout(four).order, (std::vector<int>{0, 1, 2, 3}));
  const DendrogramLayout layout = dendrogram_layout(other);
  EXPECT_EQ(layout.order, (std::vector<int>{2, 3, 0, 1}));
  EXPECT_EQ(layout.rows, (std::vector<double>{2, 3, 0, 1, 0.5, 2.5, 1.5}));
}

TEST(DendrogramLayout, OfNothingAndOfOneLeaf) {
  EXPECT_TRUE(dendrogram_layout({}).order.empty());
  EXPECT_EQ(dendrogram_layout({1, {}}).order, std::vector<int>{0});
  EXPECT_EQ(clusters_at({1, {}}, cut_height({1, {}}, 1)), 1);
}

TEST(CutHeight, LiesBetweenTwoMerges) {
  EXPECT_EQ(cut_height(four, 4), 0.5);
  EXPECT_EQ(cut_height(four, 3), 2);
  EXPECT_EQ(cut_height(four, 2), 6.5);
  EXPECT_GT(cut_height(four, 1), 10);
}

TEST(CutHeight, CutsAsCutDoes) {
  const Dendrogram tree = ward(Eigen::MatrixXd::Random(3, 30));
  for (int k = 1; k <= 30; ++k) EXPECT_EQ(clusters_at(tree, cut_height(tree, k)), k);
}

TEST(ClustersOfNodes, AreThoseOfTheirLeavesWhereTheseAgree) {
  EXPECT_EQ(clusters_of_nodes(four, cut(four, 2)), (std::vector<int>{0, 0, 1, 1, 0, 1, -1}));
  EXPECT_EQ(clusters_of_nodes(four, cut(four, 3)), (std::vector<int>{0, 0, 1, 2, 0, -1, -1}));
}

}  // namespace
}  // namespace promenade::motion
