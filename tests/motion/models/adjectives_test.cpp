#include "motion/models/adjectives.h"

#include <gtest/gtest.h>

#include <set>

#include "motion/models/adjective_pairs.h"
#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Raters who say exactly `low` and `high` of each mean, so that means and deviations
// are known: (low - high) / sqrt 2.
std::vector<Rating> two_raters(const MatrixXd& means, double apart) {
  std::vector<Rating> ratings;
  for (int p = 0; p < means.rows(); ++p) {
    for (int m = 0; m < means.cols(); ++m) {
      ratings.push_back({0, p, m, means(p, m) - apart / 2});
      ratings.push_back({1, p, m, means(p, m) + apart / 2});
    }
  }
  return ratings;
}

const MatrixXd means =
    (MatrixXd(4, 3) << -1.5, 0, 1, 0.9, -0.9, 0, 1, 1, -1, -2, 0.5, 1.4).finished();

TEST(AQuantification, HasMeansAndDeviationsOfTheRaters) {
  const Quantification q = quantify(two_raters(means, 1), 4, 3);
  EXPECT_LE((q.mean - means).norm(), 1e-14);
  EXPECT_LE((q.deviation.array() - 1 / std::sqrt(2)).matrix().norm(), 1e-14);
  EXPECT_LE((q.extreme - Eigen::Vector4d(1.5, 0.9, 1, 2)).norm(), 1e-14);
}

TEST(AQuantification, DropsAPairThatIsNeverExtreme) {
  const Quantification q = quantify(two_raters(means, 1), 4, 3);
  EXPECT_EQ(q.kept, (std::vector<int>{0, 2, 3}));  // exactly 1.0 stays
  EXPECT_EQ(q.fate[1], PairFate::never_extreme);
  EXPECT_LE((q.scaled.row(0) - (means.row(0).array() + 2).matrix() / 4).norm(), 1e-14);
}

TEST(AQuantification, DropsAPairOnWhichRatersDisagree) {
  std::vector<Rating> ratings = two_raters(means, 1);
  for (Rating& r : ratings) {
    if (r.pair == 2) r.value += r.rater == 0 ? -0.5 : 0.5;  // apart by 2: deviation 1.41
  }
  const Quantification q = quantify(ratings, 4, 3);
  EXPECT_EQ(q.fate[2], PairFate::disagreed);
  EXPECT_EQ(q.kept, (std::vector<int>{0, 3}));
}

TEST(AQuantification, DropsPairsWithoutEnoughRatings) {
  std::vector<Rating> ratings = two_raters(means, 1);
  std::erase_if(ratings, [](const Rating& r) {
    return (r.pair == 0 && r.motion == 1) || (r.pair == 3 && r.rater == 1);
  });
  const Quantification q = quantify(ratings, 4, 3);
  EXPECT_EQ(q.fate[0], PairFate::unrated);
  EXPECT_EQ(q.fate[3], PairFate::unrated);
  EXPECT_EQ(q.kept, std::vector<int>{2});
}

TEST(AQuantification, DoesNotDependOnTheOrderOfRatings) {
  std::vector<Rating> ratings;
  Random random(1);
  for (int i = 0; i < 600; ++i) {
    ratings.push_back({i % 5, i % 4, i % 3, std::round(4 * random.uniform() - 2)});
  }
  const Quantification forward = quantify(ratings, 4, 3);
  std::reverse(ratings.begin(), ratings.end());
  const Quantification backward = quantify(ratings, 4, 3);
  EXPECT_EQ(forward.mean, backward.mean);
  EXPECT_EQ(forward.deviation, backward.deviation);
}

TEST(AQuantification, CountsRepeatedRatingsOfOnePersonOnce) {
  const std::vector<Rating> ratings = {{0, 0, 0, 2}, {0, 0, 0, 1}, {0, 0, 0, 0}, {1, 0, 0, -1}};
  const Quantification q = quantify(ratings, 1, 1);
  EXPECT_DOUBLE_EQ(q.mean(0, 0), 0);
  EXPECT_DOUBLE_EQ(q.deviation(0, 0), std::sqrt(2));
}

TEST(AQuantification, OfNothingKeepsNothing) {
  const Quantification q = quantify({}, 3, 2);
  EXPECT_TRUE(q.kept.empty());
  EXPECT_EQ(q.primary.rows(), 0);
  EXPECT_EQ(q.primary.cols(), 2);
}

// Rows about three patterns, the last of them upside down.
MatrixXd patterned_rows() {
  Random random(2);
  const MatrixXd patterns = random.uniforms(3, 12);
  MatrixXd rows(10, 12);
  for (int r = 0; r < 10; ++r) rows.row(r) = patterns.row(r % 3) + 0.01 * random.normals(1, 12);
  return rows;
}

TEST(ClustersOfRows, AreThePatternsTheyWereMadeOf) {
  const Quantification q = cluster_rows(patterned_rows(), 3);
  EXPECT_EQ(q.cluster, (std::vector<int>{0, 1, 2, 0, 1, 2, 0, 1, 2, 0}));
  const MatrixXd rows = patterned_rows();
  const Eigen::RowVectorXd mean = (rows.row(1) + rows.row(4) + rows.row(7)) / 3;
  EXPECT_LE((q.primary.row(1) - mean).norm(), 1e-14);
}

TEST(ClustersOfRows, TurnBackwardRowsAroundOnRequest) {
  MatrixXd rows(4, 5);
  rows.row(0) << 0.1, 0.3, 0.5, 0.7, 0.9;
  rows.row(1) = rows.row(0);
  rows.row(2) = rows.row(0);
  rows.row(3) = 1 - rows.row(0).array();
  const Quantification q = cluster_rows(rows, 1, true);
  EXPECT_EQ(q.flipped, (std::vector<bool>{false, false, false, true}));
  EXPECT_LE((q.primary.row(0) - rows.row(0)).norm(), 1e-15);
  EXPECT_FALSE(cluster_rows(rows, 1).flipped[3]);
}

TEST(ScaledRows, RunFromZeroToOneAndStandardisedOnesHaveUnitVariance) {
  Random random(3);
  MatrixXd rows = 7 * random.normals(3, 9);
  rows.row(2).setConstant(0.3);
  const MatrixXd scaled = scaled_to_range(rows);
  EXPECT_EQ(scaled.row(0).minCoeff(), 0);
  EXPECT_EQ(scaled.row(0).maxCoeff(), 1);
  EXPECT_EQ(scaled.row(2), Eigen::RowVectorXd::Constant(9, 0.5));
  EXPECT_NEAR(standardised(rows).row(1).squaredNorm(), 8, 1e-12);
  EXPECT_EQ(standardised(rows).row(2).norm(), 0);
}

TEST(AdjectivePairs, AreFortyOneAndKnowThePrintedClusters) {
  std::set<std::string_view> right;
  int a = 0, b = 0;
  for (const AdjectivePair& pair : adjective_pairs) {
    right.insert(pair.right);
    a += pair.set_a != AdjectivePair::Cluster::none;
    b += pair.set_b != AdjectivePair::Cluster::none;
  }
  EXPECT_EQ(a, 27);
  EXPECT_EQ(b, 29);
  EXPECT_EQ(find_adjective_pair("narrow-wide"), 40);
  EXPECT_EQ(find_adjective_pair("narrow-thin"), -1);
  EXPECT_EQ(cluster_name(adjective_pairs[0].set_a), "quickness");
}

}  // namespace
}  // namespace promenade::motion
