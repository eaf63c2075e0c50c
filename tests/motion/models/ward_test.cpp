#include "motion/models/ward.h"

#include <gtest/gtest.h>

#include "tests/motion/models/random.h"
#include "tests/motion/models/vectors.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Members = std::vector<int>;

VectorXd centroid(const MatrixXd& points, const Members& members) {
  return points(Eigen::all, members).rowwise().mean();
}

// The growth of the sum of squares, by the very sums.
double growth(const MatrixXd& points, const Members& a, const Members& b) {
  const auto squares = [&points](const Members& m) {
    return (MatrixXd(points(Eigen::all, m)).colwise() - centroid(points, m)).squaredNorm();
  };
  Members both = a;
  both.insert(both.end(), b.begin(), b.end());
  return squares(both) - squares(a) - squares(b);
}

// All pairs of clusters tried at each step.
std::vector<double> brute_force_costs(const MatrixXd& points) {
  std::vector<Members> clusters;
  for (int i = 0; i < points.cols(); ++i) clusters.push_back({i});
  std::vector<double> costs;
  while (clusters.size() > 1) {
    std::size_t a = 0, b = 1;
    double least = growth(points, clusters[0], clusters[1]);
    for (std::size_t i = 0; i < clusters.size(); ++i) {
      for (std::size_t j = i + 1; j < clusters.size(); ++j) {
        const double cost = growth(points, clusters[i], clusters[j]);
        if (cost < least) least = cost, a = i, b = j;
      }
    }
    clusters[a].insert(clusters[a].end(), clusters[b].begin(), clusters[b].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(b));
    costs.push_back(least);
  }
  return costs;
}

TEST(Ward, FindsTheMergesOfBruteForce) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const MatrixXd points = Random(seed).normals(1 + seed % 5, 5 + static_cast<Index>(seed));
    const Dendrogram tree = ward(points);
    const std::vector<double> costs = brute_force_costs(points);
    ASSERT_EQ(tree.merges.size(), costs.size());
    for (std::size_t t = 0; t < costs.size(); ++t) {
      EXPECT_NEAR(tree.merges[t].cost(), costs[t], 1e-10 * (1 + costs[t]));
    }
  }
}

TEST(Ward, OfDistancesIsThatOfThePoints) {
  const MatrixXd points = Random(31).normals(6, 60);
  const Dendrogram a = ward(points);
  const Dendrogram b = ward_of_distances(euclidean_distances(points));
  for (std::size_t t = 0; t < a.merges.size(); ++t) {
    EXPECT_EQ(a.merges[t].a, b.merges[t].a);
    EXPECT_EQ(a.merges[t].b, b.merges[t].b);
    EXPECT_NEAR(a.merges[t].height, b.merges[t].height, 1e-11);
  }
}

TEST(Ward, MergesTwoPointsAtTheirDistance) {
  const Dendrogram tree = ward((MatrixXd(2, 2) << 0, 3, 0, 4).finished());
  EXPECT_DOUBLE_EQ(tree.merges[0].height, 5);
  EXPECT_DOUBLE_EQ(tree.merges[0].cost(), 12.5);
}

TEST(Ward, NeverMergesBelowItsParts) {
  MatrixXd corners = MatrixXd::Identity(40, 40) * 0.1;  // every height ties in theory
  for (const Dendrogram& tree : {ward(corners), ward_of_distances(euclidean_distances(corners))}) {
    for (std::size_t t = 1; t < tree.merges.size(); ++t) {
      EXPECT_GE(tree.merges[t].height, tree.merges[t - 1].height);
      EXPECT_LT(tree.merges[t].b, 40 + static_cast<int>(t));
    }
    EXPECT_EQ(tree.merges.back().size, 40);
  }
}

TEST(Ward, MergesDuplicatesAtZeroByRisingLeaf) {
  const Dendrogram tree = ward((MatrixXd(1, 5) << 7, 1, 7, 1, 1).finished());
  EXPECT_EQ(tree.merges[0].height, 0);
  EXPECT_EQ(tree.merges[2].height, 0);
  EXPECT_EQ(cut(tree, 2), (std::vector<int>{0, 1, 0, 1, 1}));
  EXPECT_EQ(merged_leaves(tree).back(), (Members{0, 1, 2, 3, 4}));
}

TEST(Ward, OfOnePointHasNoMerge) {
  const Dendrogram tree = ward(MatrixXd::Zero(3, 1));
  EXPECT_TRUE(tree.merges.empty());
  EXPECT_EQ(cut(tree, 1), std::vector<int>{0});
}

TEST(ACut, NumbersClustersByFirstAppearance) {
  const Dendrogram tree = ward((MatrixXd(1, 6) << 9, 0, 9.1, 5, 0.1, 5.2).finished());
  EXPECT_EQ(cut(tree, 3), (std::vector<int>{0, 1, 0, 2, 1, 2}));
  EXPECT_EQ(cut(tree, 6), (std::vector<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(cut(tree, 1), (std::vector<int>(6, 0)));
}

Dendrogram tree_of(const nlohmann::json& input) {
  if (input.contains("dist")) return ward_of_distances(to_matrix(input["dist"]));
  return ward(to_matrix(input["points"]).transpose());
}

MatrixXd distances_of(const nlohmann::json& input) {
  if (input.contains("dist")) return to_matrix(input["dist"]);
  return euclidean_distances(to_matrix(input["points"]).transpose());
}

void expect_merges(const Dendrogram& tree, const nlohmann::json& expected) {
  ASSERT_EQ(tree.merges.size(), expected["height"].size());
  for (std::size_t t = 0; t < tree.merges.size(); ++t) {
    const Merge& merge = tree.merges[t];
    const auto squared = expected["height_squared"][t].get<double>();
    EXPECT_NEAR(merge.height, expected["height"][t].get<double>(), 1e-9 * merge.height + 1e-12);
    EXPECT_NEAR(2 * merge.cost(), squared, 1e-9 * squared + 1e-12);
    EXPECT_EQ(merge.a, expected["merge_id_a"][t].get<int>());
    EXPECT_EQ(merge.b, expected["merge_id_b"][t].get<int>());
    EXPECT_EQ(merge.size, expected["size"][t].get<int>());
  }
  if (!expected.contains("merged_members")) return;
  EXPECT_EQ(merged_leaves(tree), expected["merged_members"].get<std::vector<Members>>());
}

TEST(Ward, MatchesTheVectors) {
  const nlohmann::json cases = vector_cases("ward");
  if (cases.empty()) GTEST_SKIP() << "the shared test vectors are not there";
  for (const auto& one : cases) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const auto& expected = one["expected"];
    const Dendrogram tree = tree_of(one["input"]);
    expect_merges(tree, expected);
    for (int k = 2; k <= 4; ++k) {
      const std::string key = "labels_k" + std::to_string(k);
      if (!expected.contains(key)) continue;
      EXPECT_EQ(cut(tree, k), expected[key].get<Members>());
    }
    if (!expected.contains("cophenetic_correlation")) continue;
    EXPECT_NEAR(cophenetic_correlation(tree, distances_of(one["input"])),
                expected["cophenetic_correlation"].get<double>(), 1e-9);
  }
}

}  // namespace
}  // namespace promenade::motion
