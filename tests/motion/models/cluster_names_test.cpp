#include "motion/models/cluster_names.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/models/adjective_pairs.h"
#include "motion/models/features.h"

namespace promenade::motion {
namespace {

TEST(ClusterNames, OfThePrintedClustersAreThePrintedNames) {
  const PrintedClusters table = {"b", "b", "a", "", "a"};
  const auto names = name_clusters({table}, {0, 0, 1, 2, 1}, {"x", "y", "z"});
  EXPECT_EQ(names[0].name, "b");
  EXPECT_EQ(names[1].name, "a");
  EXPECT_EQ(names[0].agreement, 1);
  EXPECT_EQ(names[2].name, "z");
  EXPECT_EQ(names[2].agreement, 0);
}

TEST(ClusterNames, AreGivenOnceToTheClusterThatAgreesMost) {
  const auto names = name_clusters({{"a", "a", "a", "a"}}, {0, 1, 1, 1}, {"rest", "others"});
  EXPECT_EQ(names[0].name, "rest");
  EXPECT_EQ(names[1].name, "a");
  EXPECT_DOUBLE_EQ(names[1].agreement, 2.0 * 3 / (3 + 4));
}

TEST(ClusterNames, TakeTheBetterOfSeveralTables) {
  const auto names = name_clusters({{"a", "", ""}, {"a", "a", ""}}, {0, 0, 1}, {"x", "y"});
  EXPECT_EQ(names[0].name, "a");
  EXPECT_EQ(names[0].agreement, 1);
}

TEST(PrintedClusters, OfAdjectivesAreThoseOfBothTables) {
  const auto tables = printed_clusters({"blunt-sharp", "hard-soft", "cold-warm"});
  EXPECT_EQ(tables[0], (PrintedClusters{"quickness", "", ""}));
  EXPECT_EQ(tables[1], (PrintedClusters{"largeness", "", ""}));
}

// Five, 12, 16 and 17 of the 50 printed names; the 51st feature is ours.
TEST(PrintedClusters, OfFeaturesHoldEachPrintedFeatureOnce) {
  const PrintedClusters clusters = printed_feature_clusters();
  ASSERT_EQ(clusters.size(), static_cast<std::size_t>(feature_count));
  const auto count = [&](std::string_view name) {
    return std::count(clusters.begin(), clusters.end(), name);
  };
  EXPECT_EQ(count("lateral swing of the upper body"), 5);
  EXPECT_EQ(count("front-back swing of the arms and legs"), 12);
  EXPECT_EQ(count("bending angle of the upper body"), 16);
  EXPECT_EQ(count("step length"), 17);
  const auto of = [&](std::string_view feature) {
    return clusters[static_cast<std::size_t>(find_feature(feature))];
  };
  EXPECT_EQ(of("sigma_com-velocity_left-right"), "");
  EXPECT_EQ(of("mu_right-thigh_left-right"), "step length");
  EXPECT_EQ(of("mu_left-thigh_left-right"), "bending angle of the upper body");
}

}  // namespace
}  // namespace promenade::motion
