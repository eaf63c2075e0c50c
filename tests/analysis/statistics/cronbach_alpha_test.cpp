#include "analysis/statistics/cronbach_alpha.h"

#include <gtest/gtest.h>

#include <cmath>

#include "study/rng.h"

namespace promenade::analysis {
namespace {

using Table = std::vector<std::vector<double>>;

double covariance(const Table& x, std::size_t a, std::size_t b) {
  const auto n = static_cast<double>(x.size());
  double mean_a = 0, mean_b = 0, sum = 0;
  for (const auto& row : x) {
    mean_a += row[a] / n;
    mean_b += row[b] / n;
  }
  for (const auto& row : x) sum += (row[a] - mean_a) * (row[b] - mean_b);
  return sum / (n - 1);
}

// By the matrix of covariances or, standardized, of correlations.
double by_matrix(const Table& x, bool standardized) {
  const std::size_t k = x[0].size();
  double diagonal = 0, all = 0;
  for (std::size_t a = 0; a < k; ++a) {
    for (std::size_t b = 0; b < k; ++b) {
      const double scale = standardized ? std::sqrt(covariance(x, a, a) * covariance(x, b, b)) : 1;
      all += covariance(x, a, b) / scale;
      diagonal += a == b ? covariance(x, a, a) / scale : 0;
    }
  }
  const auto items = static_cast<double>(k);
  return items / (items - 1) * (1 - diagonal / all);
}

Table random_answers(std::uint64_t seed, int people, int items) {
  study::Rng rng(seed, 0, "alpha");
  Table x;
  for (int i = 0; i < people; ++i) {
    const double person = rng.normal();
    auto& row = x.emplace_back();
    for (int j = 0; j < items; ++j) row.push_back(std::round(4 + 2 * person + rng.normal()));
  }
  return x;
}

Table without_item(Table x, std::size_t item) {
  for (auto& row : x) row.erase(row.begin() + static_cast<std::ptrdiff_t>(item));
  return x;
}

TEST(CronbachAlpha, IsThatOfTheMatricesOfCovariancesAndCorrelations) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Table x = random_answers(seed, 13, 4);
    const CronbachAlpha result = cronbach_alpha(x);
    EXPECT_NEAR(*result.alpha, by_matrix(x, false), 1e-12);
    EXPECT_NEAR(*result.standardized, by_matrix(x, true), 1e-12);
    ASSERT_EQ(result.if_dropped.size(), 4u);
    EXPECT_NEAR(*result.if_dropped[2], by_matrix(without_item(x, 2), false), 1e-12);
  }
}

// Two items with covariance 1/2 and variances of 1 each: 2 (1 - 2/3).
TEST(CronbachAlpha, OfTwoItemsIsKnownByHand) {
  const CronbachAlpha result = cronbach_alpha({{0, 0}, {1, 2}, {2, 1}});
  EXPECT_NEAR(*result.alpha, 2 - 4.0 / 3, 1e-15);
  EXPECT_NEAR(*result.standardized, 2 - 4.0 / 3, 1e-15);
  EXPECT_TRUE(result.if_dropped.empty());
  // Feldt with F(2, 2), whose upper quantile is (1 - p)/p.
  EXPECT_NEAR(result.interval->lower, 1 - 39 / 3.0, 1e-12);
  EXPECT_NEAR(result.interval->upper, 1 - 1 / 39.0 / 3, 1e-14);
}

// F with 2 and 4 degrees of freedom exceeds q with probability (1 + q/2)^-2.
TEST(CronbachAlpha, HasTheIntervalOfFeldt) {
  const CronbachAlpha result = cronbach_alpha({{1, 2, 1}, {2, 1, 3}, {4, 5, 3}}, 0.9);
  const double error = 1 - *result.alpha;
  EXPECT_NEAR(result.interval->lower, 1 - error * 2 * (1 / std::sqrt(0.05) - 1), 1e-12);
  EXPECT_NEAR(result.interval->upper, 1 - error * 2 * (1 / std::sqrt(0.95) - 1), 1e-12);
}

TEST(CronbachAlpha, OfEqualItemsIsOne) {
  const CronbachAlpha result = cronbach_alpha({{1, 1, 1}, {2, 2, 2}, {4, 4, 4}});
  EXPECT_NEAR(*result.alpha, 1, 1e-15);
  EXPECT_NEAR(*result.standardized, 1, 1e-15);
  EXPECT_NEAR(result.interval->lower, 1, 1e-13);
}

TEST(CronbachAlpha, IsNotDefinedWhereTotalsDoNotDiffer) {
  EXPECT_FALSE(cronbach_alpha({{1, 5}, {2, 4}, {3, 3}}).alpha);
  EXPECT_FALSE(cronbach_alpha({{1, 5}, {2, 4}, {3, 3}}).standardized);
  // 0.1 + 0.2 + 0.3 is not 0.3 + 0.2 + 0.1 in binary.
  EXPECT_FALSE(cronbach_alpha({{0.1, 0.2, 0.3}, {0.3, 0.2, 0.1}, {0.2, 0.3, 0.1}}).alpha);
  const CronbachAlpha constant = cronbach_alpha({{3, 3, 1}, {3, 3, 2}});
  EXPECT_NEAR(*constant.alpha, 0, 1e-15);
  EXPECT_FALSE(constant.standardized);
  EXPECT_FALSE(constant.if_dropped[2]);
}

TEST(CronbachAlpha, IsNotDefinedForOnePersonOrOneItem) {
  EXPECT_FALSE(cronbach_alpha({{1, 2, 3}}).alpha);
  EXPECT_FALSE(cronbach_alpha({{1, 2, 3}}).standardized);
  EXPECT_EQ(cronbach_alpha({{1, 2, 3}}).if_dropped.size(), 3u);
  EXPECT_FALSE(cronbach_alpha({{1, 2, 3}}).if_dropped[0]);
  EXPECT_FALSE(cronbach_alpha({{1}, {2}}).alpha);
  EXPECT_FALSE(cronbach_alpha({{1}, {2}}).interval);
}

TEST(CronbachAlpha, DoesNotDependOnTheUnit) {
  const Table x = random_answers(3, 13, 4);
  const CronbachAlpha result = cronbach_alpha(x);
  for (const double unit : {std::ldexp(1.0, 1000), std::ldexp(1.0, -1000)}) {
    Table scaled = x;
    for (auto& row : scaled) {
      for (double& value : row) value *= unit;
    }
    EXPECT_EQ(cronbach_alpha(scaled).alpha, result.alpha);
    EXPECT_EQ(cronbach_alpha(scaled).standardized, result.standardized);
    EXPECT_EQ(cronbach_alpha(scaled).if_dropped, result.if_dropped);
  }
}

TEST(CronbachAlpha, WithoutAnItemThatOutweighsTheOthersKeepsItsDigits) {
  Table x = random_answers(4, 13, 3);
  const double alone = *cronbach_alpha(x).alpha;
  for (std::size_t i = 0; i < x.size(); ++i) x[i].push_back(1e9 * static_cast<double>(i % 3));
  EXPECT_NEAR(*cronbach_alpha(x).if_dropped[3], alone, 1e-12);
}

}  // namespace
}  // namespace promenade::analysis
