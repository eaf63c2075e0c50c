#include "analysis/statistics/bootstrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "analysis/statistics/median.h"
#include "study/rng.h"

namespace promenade::analysis {
namespace {

std::vector<double> one_to(int n) {
  std::vector<double> x(static_cast<std::size_t>(n));
  std::iota(x.begin(), x.end(), 1.0);
  return x;
}

// How often each median comes of all n^n samples.
std::map<double, double> all_medians(const std::vector<double>& x) {
  std::map<double, double> part;
  const auto n = x.size();
  const double samples = std::pow(n, n);
  for (double code = 0; code < samples; ++code) {
    std::vector<double> sample;
    double rest = code;
    for (std::size_t i = 0; i < n; ++i) {
      sample.push_back(x[static_cast<std::size_t>(std::fmod(rest, static_cast<double>(n)))]);
      rest = std::floor(rest / static_cast<double>(n));
    }
    part[*median_of(sample)] += 1 / samples;
  }
  return part;
}

TEST(Bootstrap, DrawsMediansAsOftenAsAllSamplesHaveThem) {
  for (const std::vector<double>& x :
       {std::vector<double>{3, 1, 8, 2, 20}, {5, 1, 2, 9}, {2, 1}, {1, 1, 4, 6}}) {
    std::map<double, double> drawn;
    constexpr int count = 20000;
    for (const double median : bootstrap_replicates(Location::median, x, count, 7)) {
      drawn[median] += 1.0 / count;
    }
    for (const auto& [median, part] : all_medians(x)) {
      EXPECT_NEAR(drawn[median], part, 4 * std::sqrt(part / count)) << median;
      drawn.erase(median);
    }
    EXPECT_TRUE(drawn.empty());
  }
}

TEST(Bootstrap, HasMeansWithTheErrorOfAMean) {
  const std::vector<double> means = bootstrap_replicates(Location::mean, one_to(20), 40000, 1);
  double mean = 0, square = 0;
  for (const double value : means) {
    mean += value / 40000;
    square += value * value / 40000;
  }
  const double variance = (20.0 * 20 - 1) / 12 / 20;
  EXPECT_NEAR(mean, 10.5, 4 * std::sqrt(variance / 40000));
  EXPECT_NEAR((square - mean * mean) / variance, 1, 4 * std::sqrt(2.0 / 40000));
}

TEST(Bootstrap, IsTheSameForOneSeedEverywhere) {
  const std::vector<double> x = {2, 3, 5, 7, 11};
  const auto first = bootstrap_replicates(Location::median, x, 8, 42);
  EXPECT_EQ(first, bootstrap_replicates(Location::median, x, 8, 42));
  EXPECT_NE(first, bootstrap_replicates(Location::median, x, 8, 43));
  EXPECT_EQ(first, (std::vector<double>{7, 3, 11, 5, 3, 5, 2, 7}));
}

TEST(Bootstrap, OfNoValuesAndOfOneIsTheValue) {
  EXPECT_TRUE(bootstrap_replicates(Location::mean, {}, 10, 1).empty());
  EXPECT_EQ(bootstrap_replicates(Location::median, {3}, 2, 1), (std::vector<double>{3, 3}));
  EXPECT_TRUE(bootstrap_replicates(Location::median, {3}, 0, 1).empty());
}

// Ten thousand draws find the ends that infinitely many have, and their standard deviation.
TEST(Bootstrap, FindsTheIdealInterval) {
  std::vector<double> x;
  for (int i = 0; i < 13; ++i) x.push_back(i * i);
  const IdealMedian ideal = ideal_bootstrap_median(x, 0.95);
  ASSERT_GT(ideal.margin, 0.005);
  const std::vector<double> medians = bootstrap_replicates(Location::median, x, 10000, 5);
  const auto intervals = bootstrap_intervals(Location::median, x, medians, 0.95);
  EXPECT_EQ(intervals.percentile->lower, ideal.interval.lower);
  EXPECT_EQ(intervals.percentile->upper, ideal.interval.upper);
  double squares = 0;
  for (const double value : medians) squares += (value - *ideal.mean) * (value - *ideal.mean);
  EXPECT_NEAR(std::sqrt(squares / 10000) / *ideal.se, 1, 0.03);
}

TEST(IdealMedian, IsThatOfAllSamples) {
  const std::vector<double> x = {20, 1, 3, 8, 2};
  double mean = 0, square = 0;
  for (const auto& [median, part] : all_medians(x)) {
    mean += part * median;
    square += part * median * median;
  }
  const IdealMedian ideal = ideal_bootstrap_median(x, 0.8);
  EXPECT_NEAR(*ideal.mean, mean, 1e-12);
  EXPECT_NEAR(*ideal.se, std::sqrt(square - mean * mean), 1e-12);
  // F(1) = 10 .2^3 .8^2 + 5 .2^4 .8 + .2^5 = 0.05792, F(2) = 0.31744.
  EXPECT_EQ(ideal.lower, 2);
  EXPECT_NEAR(ideal.around_lower.lower, 0.05792, 1e-14);
  EXPECT_NEAR(ideal.around_lower.upper, 0.31744, 1e-14);
  EXPECT_EQ(ideal.interval.lower, 2);
  EXPECT_EQ(ideal.interval.upper, 8);
  EXPECT_NEAR(ideal.margin, 0.1 - 0.05792, 1e-14);
}

TEST(IdealMedian, OfOneValueIsThatValue) {
  const IdealMedian ideal = ideal_bootstrap_median({7}, 0.95);
  EXPECT_EQ(ideal.interval.lower, 7);
  EXPECT_EQ(ideal.interval.upper, 7);
  EXPECT_EQ(ideal.se, 0);
  EXPECT_EQ(ideal.upper, 1);
}

TEST(BootstrapIntervals, AreQuantilesAndTheirReflection) {
  std::vector<double> replicates = one_to(21);
  std::reverse(replicates.begin(), replicates.end());
  const auto result = bootstrap_intervals(Location::mean, {10, 12}, replicates, 0.88);
  EXPECT_NEAR(result.percentile->lower, 1 + 20 * 0.06, 1e-12);  // type 7
  EXPECT_NEAR(result.percentile->upper, 1 + 20 * 0.94, 1e-12);
  EXPECT_NEAR(result.basic->lower, 22 - (1 + 20 * 0.94), 1e-12);
  EXPECT_NEAR(result.basic->upper, 22 - (1 + 20 * 0.06), 1e-12);
}

// Symmetric influences and as many replicates above as below: the percentile interval.
TEST(BootstrapIntervals, WithoutBiasAndAccelerationAreThePercentiles) {
  const auto result = bootstrap_intervals(Location::mean, {10, 11, 12}, one_to(21), 0.9);
  EXPECT_NEAR(*result.bias, 0, 1e-15);
  EXPECT_NEAR(*result.acceleration, 0, 1e-15);
  EXPECT_NEAR(result.bca->lower, result.percentile->lower, 1e-12);
  EXPECT_NEAR(result.bca->upper, result.percentile->upper, 1e-12);
}

// A mean's jackknife: L_i = (x_i - mean)/(n - 1). Of 0, 0, 3: -1/2, -1/2, 1.
TEST(BootstrapIntervals, HaveTheAccelerationOfTheJackknife) {
  const auto result = bootstrap_intervals(Location::mean, {0, 0, 3}, {0, 1, 1, 2}, 0.9);
  EXPECT_NEAR(*result.acceleration, 0.75 / (6 * std::pow(1.5, 1.5)), 1e-14);
  const auto median = bootstrap_intervals(Location::median, {0, 1, 4}, {0, 1, 4}, 0.9);
  // Without each: 2.5, 2, 0.5; mean 5/3.
  const double squares = (25 + 4 + 49) / 36.0;
  EXPECT_NEAR(*median.acceleration, (-125 - 8 + 343) / 216.0 / (6 * std::pow(squares, 1.5)), 1e-14);
}

// Of replicates 1..99 thirty lie below 31 and one is equal: b = Phi^-1(30.5/99).
TEST(BootstrapIntervals, AreShiftedByBiasAndStretchedByAcceleration) {
  const auto result = bootstrap_intervals(Location::mean, {31, 30, 30, 30, 34}, one_to(99), 0.8);
  const auto phi = [](double z) { return std::erfc(-z / std::sqrt(2.0)) / 2; };
  const double a = *result.acceleration;
  const double b = *result.bias;
  EXPECT_NEAR(phi(b), 30.5 / 99, 1e-14);
  EXPECT_GT(a, 0.1);
  const auto end = [&](double z) { return 1 + 98 * phi(b + (b + z) / (1 - a * (b + z))); };
  EXPECT_NEAR(result.bca->lower, end(-1.2815515655446004), 1e-11);
  EXPECT_NEAR(result.bca->upper, end(1.2815515655446004), 1e-11);
}

// Three of four replicates are not above: one below, two equal by half, so b = 0 again; then
// all but one below.
TEST(BootstrapIntervals, CountReplicatesEqualToTheEstimateByHalf) {
  EXPECT_NEAR(*bootstrap_intervals(Location::mean, {0, 2}, {0, 1, 1, 2}, 0.9).bias, 0, 1e-15);
  const double third = 1.0 / 3;
  const auto rounded =
      bootstrap_intervals(Location::mean, {0, 0, 1}, {third, third - 1e-17, third + 1e-16}, 0.9);
  EXPECT_NEAR(*rounded.bias, 0, 1e-15);
  // Phi^-1(3/4).
  EXPECT_NEAR(*bootstrap_intervals(Location::mean, {0, 2}, {0, 0, 0, 2}, 0.9).bias,
              0.6744897501960817, 1e-12);
}

TEST(BootstrapIntervals, AreNotDefinedWhereTheirPartsAreNot) {
  const auto none = bootstrap_intervals(Location::mean, {}, {}, 0.9);
  EXPECT_FALSE(none.estimate || none.percentile || none.basic || none.bias || none.bca);
  const auto one = bootstrap_intervals(Location::mean, {2}, {2, 2}, 0.9);
  EXPECT_TRUE(one.percentile && one.bias);
  EXPECT_FALSE(one.acceleration || one.bca);
  const auto equal = bootstrap_intervals(Location::median, {0.1, 0.1, 0.1}, {0.1}, 0.9);
  EXPECT_FALSE(equal.acceleration || equal.bca);
  const auto aside = bootstrap_intervals(Location::mean, {1, 3}, {7, 8}, 0.9);
  EXPECT_TRUE(aside.percentile);
  EXPECT_FALSE(aside.bias || aside.bca);
}

TEST(BootstrapIntervals, OfHugeValuesAreThoseThatADoubleHolds) {
  const auto result = bootstrap_intervals(Location::median, {-1e308, 0, 1e308, 1.5e308},
                                          {-1e308, 1.5e308, 1e308}, 0.9);
  EXPECT_EQ(result.estimate, 0.5e308);
  EXPECT_TRUE(result.acceleration);
  EXPECT_TRUE(std::isfinite(result.percentile->upper));
  EXPECT_FALSE(bootstrap_intervals(Location::mean, {1e308, 1e308, 1e308}, {0}, 0.9).estimate);
}

}  // namespace
}  // namespace promenade::analysis
