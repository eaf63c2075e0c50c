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

}  // namespace
}  // namespace promenade::analysis
