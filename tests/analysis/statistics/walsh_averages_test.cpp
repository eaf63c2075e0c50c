#include "analysis/statistics/walsh_averages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace promenade::analysis {
namespace {

std::vector<double> by_brute_force(const std::vector<double>& d) {
  std::vector<double> all;
  for (std::size_t i = 0; i < d.size(); ++i) {
    for (std::size_t j = i; j < d.size(); ++j) all.push_back(d[i] / 2 + d[j] / 2);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void expect_as_by_brute_force(const std::vector<double>& d) {
  const WalshAverages walsh(d);
  const std::vector<double> all = by_brute_force(d);
  ASSERT_EQ(walsh.size(), static_cast<std::int64_t>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(walsh[static_cast<std::int64_t>(i)], all[i]) << i << " of " << all.size();
  }
}

TEST(WalshAverages, AreThoseOfAllPairsInOrder) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.1, 1);
  for (const int n : {1, 2, 3, 8, 25}) {
    std::vector<double> d;
    for (int i = 0; i < n; ++i) d.push_back(normal(random));
    expect_as_by_brute_force(d);
  }
}

TEST(WalshAverages, KeepTiesAndZeros) {
  expect_as_by_brute_force({0, -0.0, 1, 1, -1, 0, 2, -2, 1});
  expect_as_by_brute_force({-3, -3, -3});
}

TEST(WalshAverages, ReachFromTheSmallestNumbersToTheLargest) {
  expect_as_by_brute_force({1.7e308, -1.7e308, 1e-300, -1e-300, 1.6e308, 3e-308, 1});
}

TEST(WalshAverages, OfThousandsAreFoundWithoutWritingThemDown) {
  std::vector<double> d(100'000);  // all of them would take 40 GB
  for (std::size_t i = 0; i < d.size(); ++i) d[i] = static_cast<double>(i);
  const WalshAverages walsh(d);
  EXPECT_EQ(walsh[walsh.size() / 2], 49'999.5);
}

}  // namespace
}  // namespace promenade::analysis
