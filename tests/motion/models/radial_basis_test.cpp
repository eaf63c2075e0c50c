#include "motion/models/radial_basis.h"

#include <gtest/gtest.h>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Size {
  Index parameters, examples;
};
constexpr Size sizes[] = {{1, 2}, {1, 10}, {4, 10}, {4, 27}, {9, 10}, {12, 10}, {51, 10}, {26, 27}};

TEST(RawWeights, AreTheExampleAtEachExample) {
  for (const Size& size : sizes) {
    SCOPED_TRACE(size.parameters);
    const MatrixXd p = Random(static_cast<std::uint64_t>(size.parameters))
                           .uniforms(size.parameters, size.examples);
    const RadialBasis basis = fit_radial_basis(p);
    for (Index j = 0; j < size.examples; ++j) {
      const VectorXd weights = raw_weights(basis, p.col(j));
      EXPECT_LE((weights - VectorXd::Unit(size.examples, j)).cwiseAbs().maxCoeff(), 1e-9);
    }
  }
}

TEST(RawWeights, SumToOneEverywhere) {
  for (const Size& size : sizes) {
    Random random(100 + static_cast<std::uint64_t>(size.parameters));
    const RadialBasis basis = fit_radial_basis(random.uniforms(size.parameters, size.examples));
    for (int i = 0; i < 100; ++i) {
      const VectorXd at = 3 * random.normals(size.parameters, 1);
      EXPECT_NEAR(raw_weights(basis, at).sum(), 1, 1e-9);
    }
  }
}

TEST(RawWeights, DoNotExplodeWhereTheExamplesBarelyDiffer) {
  Random random(3);
  MatrixXd p = random.uniforms(26, 27);
  p.row(25) *= 1e-3;
  const MatrixXd centred = p.colwise() - p.rowwise().mean();
  const double widest = centred.operatorNorm();
  const RadialBasisOptions options{.smallest_singular = 0.05, .same_example = 1e-6};
  EXPECT_LE(fit_radial_basis(p, options).linear.operatorNorm(), 1 / (0.05 * widest));
  const RadialBasisOptions uncut{.smallest_singular = 1e-4, .same_example = 1e-6};
  EXPECT_GE(fit_radial_basis(p, uncut).linear.operatorNorm(), 100);
}

TEST(RawWeights, AreNegativeAboutAsOftenAsTheMethodSays) {
  Random random(4);
  int negative = 0;
  constexpr int tries = 200;
  for (int i = 0; i < tries; ++i) {
    const RadialBasis basis = fit_radial_basis(random.uniforms(4, 27));
    negative += static_cast<int>((raw_weights(basis, random.uniforms(4, 1)).array() < 0).count());
  }
  const double share = negative / (27.0 * tries);
  EXPECT_GT(share, 0.25);
  EXPECT_LT(share, 0.50);
}

TEST(RawWeights, AreUniformWithoutParameters) {
  const RadialBasis basis = fit_radial_basis(MatrixXd(0, 7));
  EXPECT_EQ(raw_weights(basis, VectorXd(0)), VectorXd::Constant(7, 1.0 / 7));
}

TEST(RawWeights, OfDuplicatesAreShared) {
  MatrixXd p = Random(5).uniforms(3, 8);
  p.col(6) = p.col(2);
  p.col(7) = p.col(2);
  const RadialBasis basis = fit_radial_basis(p);
  VectorXd expected = VectorXd::Zero(8);
  expected(2) = expected(6) = expected(7) = 1.0 / 3;
  EXPECT_LE((raw_weights(basis, p.col(2)) - expected).norm(), 1e-12);
  EXPECT_LE((raw_weights(basis, p.col(5)) - VectorXd::Unit(8, 5)).norm(), 1e-12);
}

TEST(RawWeights, TellNearDuplicatesApart) {
  MatrixXd p = Random(6).uniforms(2, 6);
  p.col(5) = p.col(1).array() + 1e-4;
  const RadialBasis basis = fit_radial_basis(p);
  EXPECT_LE((raw_weights(basis, p.col(5)) - VectorXd::Unit(6, 5)).norm(), 1e-9);
}

TEST(RawWeights, OfASubsetAreThoseOfItsRowsAlone) {
  Random random(7);
  const MatrixXd p = random.uniforms(5, 9);
  const MatrixXd rows = (MatrixXd(2, 9) << p.row(3), p.row(1)).finished();
  const VectorXd at = random.uniforms(2, 1);
  EXPECT_EQ(raw_weights(fit_radial_basis(p, std::vector<int>{3, 1}), at),
            raw_weights(fit_radial_basis(rows), at));
}

TEST(RawWeights, AreLinearWhereTheExamplesAreOnALine) {
  const MatrixXd p = (MatrixXd(1, 2) << 0, 1).finished();
  const RadialBasis basis = fit_radial_basis(p);
  for (const double x : {0.0, 0.25, 0.5, 1.0}) {
    const VectorXd weights = raw_weights(basis, VectorXd::Constant(1, x));
    EXPECT_LE((weights - Eigen::Vector2d(1 - x, x)).norm(), 1e-14);
  }
}

TEST(TheCubicSpline, IsSmoothAndEndsAtTwo) {
  EXPECT_DOUBLE_EQ(cubic_spline(0), 2.0 / 3);
  EXPECT_DOUBLE_EQ(cubic_spline(1), 1.0 / 6);
  EXPECT_NEAR(cubic_spline(1 - 1e-9), cubic_spline(1 + 1e-9), 2e-9);
  EXPECT_EQ(cubic_spline(2), 0);
  double sum = 0;  // a partition of unity on the integers
  for (int i = -3; i <= 3; ++i) sum += cubic_spline(0.37 + i);
  EXPECT_NEAR(sum, 1, 1e-15);
}

TEST(TheRuleForNegativeWeights, ClampsAndNormalises) {
  VectorXd weights = Eigen::Vector3d(-0.5, 0.3, 1.2);
  apply_rule(NegativeRule::clamp, weights);
  EXPECT_LE((weights - Eigen::Vector3d(0, 0.3, 1) / 1.3).norm(), 1e-15);
}

TEST(TheRuleForNegativeWeights, MayKeepThem) {
  VectorXd weights = Eigen::Vector3d(-0.5, 0.3, 1.2);
  apply_rule(NegativeRule::keep, weights);
  EXPECT_EQ(weights, Eigen::Vector3d(-0.5, 0.3, 1.2));
}

// Tries every set of positive entries: the nearest feasible point of them all.
VectorXd projected_by_brute_force(const VectorXd& v) {
  VectorXd best = VectorXd::Unit(v.size(), 0);
  for (int set = 1; set < (1 << v.size()); ++set) {
    VectorXd w = VectorXd::Zero(v.size());
    double sum = 0;
    int count = 0;
    for (int i = 0; i < v.size(); ++i) {
      if (set >> i & 1) sum += v(i), ++count;
    }
    for (int i = 0; i < v.size(); ++i) {
      if (set >> i & 1) w(i) = v(i) - (sum - 1) / count;
    }
    if (w.minCoeff() >= 0 && (w - v).norm() < (best - v).norm()) best = w;
  }
  return best;
}

TEST(TheProjectionOnTheSimplex, IsTheNearestPoint) {
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    const VectorXd v = random.normals(1 + i % 7, 1);
    VectorXd w = v;
    project_on_simplex(w);
    EXPECT_LE((w - projected_by_brute_force(v)).norm(), 1e-12);
  }
}

TEST(TheProjectionOnTheSimplex, LeavesWeightsOfABlendAlone) {
  VectorXd weights = Eigen::Vector4d(0.1, 0, 0.6, 0.3);
  apply_rule(NegativeRule::project, weights);
  EXPECT_LE((weights - Eigen::Vector4d(0.1, 0, 0.6, 0.3)).norm(), 1e-15);
}

}  // namespace
}  // namespace promenade::motion
