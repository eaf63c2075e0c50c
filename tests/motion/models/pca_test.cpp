#include "motion/models/pca.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/models/ward.h"
#include "tests/motion/models/random.h"
#include "tests/motion/models/vectors.h"

namespace promenade::motion {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd centred(const MatrixXd& x) { return x.colwise() - x.rowwise().mean(); }

void expect_near(const MatrixXd& a, const MatrixXd& b, double tolerance) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance);
}

TEST(PrincipalComponents, KeepEveryDistanceBetweenExamples) {
  const MatrixXd x = Random(1).normals(700, 12);
  const Pca pca = principal_components(x);
  EXPECT_EQ(pca.components(), 11);
  expect_near(euclidean_distances(pca.coordinates), euclidean_distances(x), 1e-11);
}

TEST(PrincipalComponents, HaveTheVariancesOfTheirCoordinates) {
  const MatrixXd x = Random(2).normals(300, 9);
  const Pca pca = principal_components(x);
  for (int k = 0; k < pca.components(); ++k) {
    EXPECT_NEAR(pca.coordinates.row(k).sum(), 0, 1e-11);
    EXPECT_NEAR(pca.coordinates.row(k).squaredNorm() / 8, pca.variances(k), 1e-10);
    EXPECT_LE(pca.variances(k), pca.variances(std::max(0, k - 1)));
  }
  EXPECT_NEAR(pca.total_variance, centred(x).squaredNorm() / 8, 1e-9);
}

TEST(PrincipalComponents, EqualClassicalScalingOfTheDistances) {
  const MatrixXd x = Random(3).normals(5952, 20);
  const Pca pca = principal_components(x);
  const ClassicalScaling scaling = classical_scaling(euclidean_distances(x), 2);
  expect_near(pca.coordinates.topRows(2), scaling.points, 1e-11 * x.norm());
}

TEST(PrincipalComponents, DropWhatIsOnlyRounding) {
  Random random(4);
  const MatrixXd x = random.normals(200, 3) * random.normals(3, 30);
  EXPECT_EQ(principal_components(x).components(), 3);
}

TEST(PrincipalComponents, PutTheLargestExampleOnThePositiveSide) {
  const Pca pca = principal_components(Random(5).normals(50, 8));
  for (int k = 0; k < pca.components(); ++k) {
    EXPECT_GE(pca.coordinates.row(k).maxCoeff(), -pca.coordinates.row(k).minCoeff());
  }
}

TEST(PrincipalComponents, LetTheFirstNameDecideWhenTwoExamplesTie) {
  const MatrixXd x = (MatrixXd(2, 2) << 1, -1, 3, -3).finished();
  EXPECT_GT(principal_components(x, {"a", "b"}).coordinates(0, 0), 0);
  EXPECT_LT(principal_components(x, {"b", "a"}).coordinates(0, 0), 0);
}

TEST(PrincipalComponents, DoNotDependOnTheOrderOfExamples) {
  const MatrixXd x = Random(6).normals(400, 10);
  const Pca forward = principal_components(x);
  const Pca backward = principal_components(x.rowwise().reverse());
  expect_near(backward.coordinates.rowwise().reverse(), forward.coordinates, 1e-10);
}

TEST(PrincipalComponents, TurnWeightsIntoCoordinatesAndBack) {
  Random random(7);
  const MatrixXd x = random.normals(100, 6);
  const Pca pca = principal_components(x);
  VectorXd weights = random.normals(6, 1);
  weights.array() += (1 - weights.sum()) / 6;
  expect_near(weights_of(pca, coordinates_of(pca, weights)), weights, 1e-12);
  const VectorXd alpha = random.normals(4, 1);
  EXPECT_NEAR(weights_of(pca, alpha).sum(), 1, 1e-12);
  expect_near(coordinates_of(pca, weights_of(pca, alpha)).head(4), alpha, 1e-11);
}

TEST(PrincipalComponents, GiveTheAverageAtTheOrigin) {
  const Pca pca = principal_components(Random(8).normals(100, 5));
  expect_near(weights_of(pca, VectorXd::Zero(2)), VectorXd::Constant(5, 0.2), 1e-15);
}

TEST(TableComponents, MatchTheVectors) {
  const nlohmann::json cases = vector_cases("pca");
  if (cases.empty()) GTEST_SKIP() << "the shared test vectors are not there";
  for (const auto& one : cases) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const auto& expected = one["expected"];
    const TablePca pca = table_components(to_matrix(one["input"]["X"]), one["input"]["scale"]);
    EXPECT_EQ(pca.deviations.size(), expected["rank"].get<int>());
    const VectorXd deviations = to_vector(expected["sdev"]);
    expect_near(pca.deviations, deviations, 1e-9 * deviations(0));
    expect_near(pca.explained, to_vector(expected["explained_ratio"]), 1e-9);
    expect_near(pca.rotation, to_matrix(expected["rotation"]), 1e-7);
    if (!expected.contains("scores")) continue;
    const MatrixXd scores = to_matrix(expected["scores"]);
    expect_near(pca.scores, scores, 1e-7 * scores.cwiseAbs().maxCoeff());
  }
}

TEST(TableComponents, AreThoseOfTheGramMatrix) {
  const MatrixXd x = Random(9).normals(40, 7);  // 7 examples
  const TablePca table = table_components(x.transpose(), false);
  const Pca pca = principal_components(x);
  expect_near(table.deviations.cwiseAbs2(), pca.variances, 1e-11);
  expect_near(table.scores.transpose().cwiseAbs(), pca.coordinates.cwiseAbs(), 1e-11);
}

TEST(TableComponents, SkipColumnsThatDoNotVary) {
  MatrixXd table = Random(10).normals(20, 3);
  table.col(1).setConstant(0.3);
  const TablePca pca = table_components(table, true);
  EXPECT_EQ(pca.deviations.size(), 2);
  EXPECT_NEAR(pca.deviations.squaredNorm(), 2, 1e-12);
}

TEST(ClassicalScaling, MatchesTheVectors) {
  const nlohmann::json cases = vector_cases("classical_mds");
  if (cases.empty()) GTEST_SKIP() << "the shared test vectors are not there";
  for (const auto& one : cases) {
    SCOPED_TRACE(one["id"].get<std::string>());
    const auto& expected = one["expected"];
    const ClassicalScaling mds =
        classical_scaling(to_matrix(one["input"]["dist"]), one["input"]["k"]);
    const VectorXd values = to_vector(expected["eig"]);
    expect_near(mds.eigenvalues, values, 1e-9 * values(0));
    EXPECT_EQ(mds.points.rows(), expected["k_used"].get<int>());
    EXPECT_NEAR(mds.goodness[0], expected["gof"][0].get<double>(), 1e-9);
    EXPECT_NEAR(mds.goodness[1], expected["gof"][1].get<double>(), 1e-9);
    if (!expected.contains("points")) continue;
    const MatrixXd points = to_matrix(expected["points"]);
    expect_near(mds.points.transpose(), points, 1e-7 * points.cwiseAbs().maxCoeff());
  }
}

TEST(ClassicalScaling, OfPointsThatCoincideHasNoAxis) {
  const ClassicalScaling mds = classical_scaling(MatrixXd::Zero(4, 4), 2);
  EXPECT_EQ(mds.points.rows(), 0);
  EXPECT_TRUE(std::isnan(mds.goodness[0]));
}

}  // namespace
}  // namespace promenade::motion
