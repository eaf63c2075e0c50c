#include "motion/models/rand_index.h"

#include <gtest/gtest.h>

#include "motion/models/adjective_pairs.h"

namespace promenade::motion {
namespace {

TEST(RandIndex, IsOneForTheSameClustersUnderOtherLabels) {
  EXPECT_EQ(adjusted_rand_index({0, 0, 1, 1, 2}, {5, 5, 3, 3, 0}), 1);
}

// The examples in the documentation of scikit-learn's adjusted_rand_score.
TEST(RandIndex, IsThatOfScikitLearn) {
  EXPECT_NEAR(adjusted_rand_index({0, 0, 1, 1}, {0, 0, 1, 2}), 0.5714285714285714, 1e-15);
  EXPECT_NEAR(adjusted_rand_index({0, 0, 1, 2}, {0, 0, 1, 1}), 0.5714285714285714, 1e-15);
  EXPECT_EQ(adjusted_rand_index({0, 0, 0, 0}, {0, 1, 2, 3}), 0);
  EXPECT_NEAR(adjusted_rand_index({0, 0, 1, 1}, {0, 1, 0, 1}), -0.5, 1e-15);
}

// By counting pairs in R, from the table of both: choose(n_ij, 2) and so on.
TEST(RandIndex, IsThatOfItsFormulaInR) {
  EXPECT_NEAR(adjusted_rand_index({0, 0, 1, 1, 2, 2, 2, 3}, {0, 0, 0, 1, 1, 2, 2, 2}),
              0.1578947368421053, 1e-15);
}

TEST(RandIndex, IsOneWhereThereIsNothingToTellApart) {
  EXPECT_EQ(adjusted_rand_index({}, {}), 1);
  EXPECT_EQ(adjusted_rand_index({3}, {1}), 1);
  EXPECT_EQ(adjusted_rand_index({0, 0, 0}, {1, 1, 1}), 1);
  EXPECT_EQ(adjusted_rand_index({0, 1, 2}, {2, 1, 0}), 1);
}

TEST(PrintedComparison, LeavesOutWhatThePrintedClustersDo) {
  const PrintedComparison found =
      compare_with_printed({0, 0, 1, 1, 2}, {"quickness", "", "largeness", "largeness", ""});
  EXPECT_EQ(found.items, (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(found.missing, (std::vector<int>{1, 4}));
  EXPECT_EQ(found.rand_index, 1);
}

// Sets A and B have 22 pairs in common, in rather different clusters: that much, computed from the
// printed tables in Python, is what two sets of motions can be expected to agree.
TEST(PrintedComparison, OfTheSourcesTwoTables) {
  const std::vector<std::string> pairs = [] {
    std::vector<std::string> names;
    for (const AdjectivePair& one : adjective_pairs) {
      names.push_back(std::string(one.left) + "-" + std::string(one.right));
    }
    return names;
  }();
  const auto tables = printed_clusters(pairs);
  std::vector<int> of_a;
  PrintedClusters of_b;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (tables[0][i].empty()) continue;
    of_a.push_back(static_cast<int>(adjective_pairs[i].set_a));
    of_b.push_back(tables[1][i]);
  }
  const PrintedComparison found = compare_with_printed(of_a, of_b);
  EXPECT_EQ(of_a.size(), 27U);
  EXPECT_EQ(found.items.size(), 22U);
  EXPECT_NEAR(found.rand_index, 0.13835198372329605, 1e-15);
}

}  // namespace
}  // namespace promenade::motion
