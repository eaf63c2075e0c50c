#include "analysis/statistics/sign_flips.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace promenade::analysis {
namespace {

// By all 2^n assignments.
std::vector<double> by_brute_force(const std::vector<std::int64_t>& ranks, std::int64_t last) {
  std::vector<double> probability(static_cast<std::size_t>(last) + 1, 0.0);
  const unsigned all = 1u << ranks.size();
  for (unsigned chosen = 0; chosen < all; ++chosen) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) sum += (chosen >> i & 1u) ? ranks[i] : 0;
    if (sum <= last) probability[static_cast<std::size_t>(sum)] += 1.0 / all;
  }
  return probability;
}

TEST(SignFlips, EqualTheCountOfAllAssignmentsBitForBit) {
  const std::vector<std::int64_t> ranks = {7, 2, 2, 11, 5, 5, 5, 14, 18, 3};
  for (const std::int64_t last : {0, 1, 10, 36, 72}) {
    EXPECT_EQ(sign_flip_distribution(ranks, last), by_brute_force(ranks, last)) << last;
  }
}

TEST(SignFlips, OfNoRanksAreCertainlyZero) {
  EXPECT_EQ(sign_flip_distribution({}, 2), (std::vector<double>{1, 0, 0}));
}

TEST(SignFlips, HaveTheMeanAndVarianceOfTheirRanks) {
  std::vector<std::int64_t> ranks(100);
  std::iota(ranks.begin(), ranks.end(), std::int64_t{1});
  double total = 0, mean = 0, square = 0;
  double s = 0;
  for (const double p : sign_flip_distribution(ranks, 5050)) {
    total += p;
    mean += p * s;
    square += p * s * s;
    s += 1;
  }
  EXPECT_NEAR(total, 1, 1e-13);
  EXPECT_NEAR(mean, 5050.0 / 2, 1e-9);
  EXPECT_NEAR(square - mean * mean, 100.0 * 101 * 201 / 24, 1e-6);
}

TEST(SignFlips, KeepTheSmallestProbabilityOfAThousandRanks) {
  const std::vector<std::int64_t> ranks(1000, 1);  // binomial
  const std::vector<double> probability = sign_flip_distribution(ranks, 1);
  EXPECT_EQ(probability[0], std::ldexp(1.0, -1000));
  EXPECT_EQ(probability[1], std::ldexp(1000.0, -1000));
}

TEST(SignFlipTail, IsTheSumOfTheDistribution) {
  const std::vector<std::int64_t> samples[] = {
      {}, {1}, {4, 4}, {1, 40}, {7, 2, 2, 11, 5, 5, 5, 14, 18, 3}, {1, 1, 1, 1, 1, 1, 1, 30, 31}};
  for (const auto& ranks : samples) {
    const std::int64_t all = std::accumulate(ranks.begin(), ranks.end(), std::int64_t{0});
    double below = 0;
    for (std::int64_t last = 0; last <= all + 3; ++last) {
      const auto [tail, at] = sign_flip_tail(ranks, last);
      EXPECT_EQ(tail, below) << last;
      EXPECT_EQ(at, by_brute_force(ranks, last).back()) << last;
      below += at;
    }
  }
}

TEST(SignFlipTail, KeepsItsDigitsForHundredsOfRanks) {
  std::vector<std::int64_t> ranks;
  for (std::int64_t i = 0; i < 300; ++i) ranks.push_back(2 + 2 * (i / 7) * 7 + i % 3);
  for (const std::int64_t last : {0, 5, 900, 12000, 40000}) {
    const std::vector<double> p = sign_flip_distribution(ranks, last);
    const auto [below, at] = sign_flip_tail(ranks, last);
    EXPECT_NEAR(at, p.back(), 1e-12 * p.back());
    const double sum = std::accumulate(p.begin(), p.end() - 1, 0.0);
    EXPECT_NEAR(below, sum, 1e-12 * sum);
  }
}

TEST(SignFlipTail, OfTwoThousandRanksStaysInRange) {
  const std::vector<std::int64_t> ranks(2000, 1);  // binomial
  const auto [below, at] = sign_flip_tail(ranks, 1000);
  EXPECT_NEAR(2 * below + at, 1, 1e-12);
  EXPECT_NEAR(at, std::exp(std::lgamma(2001) - 2 * std::lgamma(1001) - 2000 * std::log(2)), 1e-12);
  EXPECT_EQ(sign_flip_tail(std::vector<std::int64_t>(1000, 1), 1).at, std::ldexp(1000.0, -1000));
}

}  // namespace
}  // namespace promenade::analysis
