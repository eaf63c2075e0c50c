#include "motion/models/gram.h"

#include <gtest/gtest.h>

#include "tests/motion/models/random.h"

namespace promenade::motion {
namespace {

using Eigen::MatrixXd;

MatrixXd by_definition(const MatrixXd& x) {
  const MatrixXd centred = x.colwise() - x.rowwise().mean();
  return (centred.transpose() * centred).triangularView<Eigen::Lower>();
}

TEST(ACentredGram, IsTheProductOfTheCentredColumns) {
  Random random(1);
  for (const int n : {1, 2, 5, 16, 17, 55}) {
    for (const int d : {1, 63, 64, 65, 300}) {
      const MatrixXd x = random.normals(d, n);
      EXPECT_LE((centred_gram(x) - by_definition(x)).cwiseAbs().maxCoeff(), 1e-13 * d)
          << n << " columns of " << d;
    }
  }
}

TEST(ACentredGram, HasTheSameDigitsOnEveryProcessor) {
  if (!has_wide()) GTEST_SKIP() << "this processor has no AVX2: there is one way here";
  Random random(4);
  for (const int n : {1, 3, 16, 27, 55}) {
    for (const int d : {1, 64, 301}) {
      const MatrixXd x = random.normals(d, n);
      EXPECT_EQ(centred_gram(x, true), centred_gram(x, false)) << n << " columns of " << d;
    }
  }
}

TEST(ACentredGram, DoesNotSeeWhereTheColumnsLie) {
  const MatrixXd x = Random(2).normals(200, 9);
  const MatrixXd moved = x.colwise() + Eigen::VectorXd(Random(3).normals(200, 1));
  EXPECT_LE((centred_gram(moved) - centred_gram(x)).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace promenade::motion
