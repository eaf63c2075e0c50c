#include "analysis/statistics/icc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "analysis/statistics/f_quantile.h"
#include "study/rng.h"

namespace promenade::analysis {
namespace {

using Table = std::vector<std::vector<double>>;

// Shrout & Fleiss (1979), tables 2 to 4: six targets, four raters.
const Table& published() {
  static const Table x = {{9, 2, 5, 8}, {6, 1, 3, 2},  {8, 4, 6, 8},
                          {7, 1, 2, 6}, {10, 5, 6, 9}, {6, 2, 4, 7}};
  return x;
}

TEST(Icc, IsAsShroutAndFleissPrintedIt) {
  const Icc result = icc(published());
  EXPECT_NEAR(*result.ms_rows, 11.24, 0.005);
  EXPECT_NEAR(*result.ms_within, 6.26, 0.005);
  EXPECT_NEAR(*result.ms_cols, 32.49, 0.005);
  EXPECT_NEAR(*result.ms_error, 1.02, 0.005);
  EXPECT_NEAR(*result.one_way, 0.17, 0.005);
  EXPECT_NEAR(*result.agreement, 0.29, 0.005);
  EXPECT_NEAR(*result.consistency, 0.71, 0.005);
  EXPECT_NEAR(*result.one_way_mean, 0.44, 0.005);
  EXPECT_NEAR(*result.agreement_mean, 0.62, 0.005);
  EXPECT_NEAR(*result.consistency_mean, 0.91, 0.005);
  EXPECT_NEAR(result.interval->lower, 0.02, 0.005);
  EXPECT_NEAR(result.interval->upper, 0.76, 0.005);
}

TEST(Icc, OfAMeanIsSpearmanAndBrownsOfOneRating) {
  const Icc result = icc(published());
  const auto of_mean = [](double r) { return 4 * r / (1 + 3 * r); };
  EXPECT_NEAR(*result.one_way_mean, of_mean(*result.one_way), 1e-13);
  EXPECT_NEAR(*result.agreement_mean, of_mean(*result.agreement), 1e-13);
  EXPECT_NEAR(*result.consistency_mean, of_mean(*result.consistency), 1e-13);
  EXPECT_NEAR(result.interval_mean->lower, of_mean(result.interval->lower), 1e-13);
}

// The mean squares by differences of all pairs of numbers: sum (x - mean)^2 = sum over pairs
// (x - y)^2 / n.
double pair_variance(const std::vector<double>& x) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) sum += (x[i] - x[j]) * (x[i] - x[j]);
  }
  const auto n = static_cast<double>(x.size());
  return sum / n / (n - 1);
}

TEST(Icc, HasTheMeanSquaresOfPairs) {
  study::Rng rng(1, 0, "icc");
  Table x(7, std::vector<double>(3));
  std::vector<double> row_means, column_means(3, 0.0);
  double within = 0;
  for (auto& row : x) {
    for (double& value : row) value = rng.normal();
    row_means.push_back((row[0] + row[1] + row[2]) / 3);
    within += pair_variance(row) / 7;
    for (std::size_t j = 0; j < 3; ++j) column_means[j] += row[j] / 7;
  }
  const Icc result = icc(x);
  EXPECT_NEAR(*result.ms_rows, 3 * pair_variance(row_means), 1e-13);
  EXPECT_NEAR(*result.ms_cols, 7 * pair_variance(column_means), 1e-13);
  EXPECT_NEAR(*result.ms_within, within, 1e-13);
  // Within targets there are raters and the rest: 7 * 2 = 2 + 6 * 2 degrees of freedom.
  EXPECT_NEAR(14 * within, 2 * *result.ms_cols + 12 * *result.ms_error, 1e-12);
}

TEST(Icc, OfPerfectAgreementIsOneAndHasNoF) {
  const Icc result = icc({{0.1, 0.1, 0.1}, {0.7, 0.7, 0.7}, {0.4, 0.4, 0.4}});
  EXPECT_EQ(result.agreement, 1.0);
  EXPECT_EQ(result.one_way, 1.0);
  EXPECT_EQ(result.ms_error, 0.0);
  EXPECT_FALSE(result.f_rows || result.p_rows || result.interval);
}

TEST(Icc, OfRatersWhoDifferByAConstantIsConsistentOnly) {
  const Icc result = icc({{1, 2}, {2, 3}, {3, 4}, {4, 5}});
  EXPECT_EQ(result.consistency, 1.0);
  EXPECT_LT(*result.agreement, 0.9);
  EXPECT_EQ(result.ms_error, 0.0);
}

TEST(Icc, IsNotDefinedWithoutVariance) {
  const Icc result = icc({{3, 3}, {3, 3}});
  EXPECT_EQ(result.ms_rows, 0.0);
  EXPECT_FALSE(result.one_way || result.agreement || result.consistency);
  EXPECT_FALSE(result.one_way_mean || result.interval);
}

TEST(Icc, IsNotDefinedForOneTargetOrOneRater) {
  const Icc target = icc({{1, 2, 3}});
  EXPECT_FALSE(target.ms_rows || target.ms_error || target.agreement);
  EXPECT_NEAR(*target.ms_cols, 1, 1e-14);
  const Icc rater = icc({{1}, {2}});
  EXPECT_FALSE(rater.ms_cols || rater.ms_within || rater.one_way);
  EXPECT_NEAR(*rater.ms_rows, 0.5, 1e-14);
}

TEST(Icc, OfHugeAndTinyRatingsIsThatOfOthers) {
  const Icc result = icc(published());
  for (const double unit : {std::ldexp(1.0, 1000), std::ldexp(1.0, -1000)}) {
    Table x = published();
    for (auto& row : x) {
      for (double& value : row) value *= unit;
    }
    EXPECT_EQ(icc(x).agreement, result.agreement);
    EXPECT_EQ(icc(x).p_rows, result.p_rows);
    EXPECT_EQ(icc(x).interval->lower, result.interval->lower);
    EXPECT_EQ(icc(x).ms_rows.has_value(), unit < 1);  // 2^2000 is no double
  }
}

// F with 2 and 2 degrees of freedom exceeds q with probability 1/(1 + q).
TEST(FQuantile, IsKnownForTwoAndTwoDegreesOfFreedom) {
  for (const double p : {1e-12, 0.025, 0.5, 0.975}) {
    EXPECT_NEAR(f_upper_quantile(p, 2, 2) / ((1 - p) / p), 1, 1e-12);
  }
  EXPECT_NEAR(f_upper_quantile(0.2, 3, 7.5) * f_upper_quantile(0.8, 7.5, 3), 1, 1e-12);
  EXPECT_EQ(f_upper_quantile(0.025, 1, 1e-8), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace promenade::analysis
