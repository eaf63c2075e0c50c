#include "analysis/statistics/krippendorff_alpha.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "study/rng.h"

namespace promenade::analysis {
namespace {

using Ratings = std::vector<std::vector<std::optional<double>>>;

// Krippendorff (2011), "Computing Krippendorff's alpha-reliability", example C.
const Ratings& published() {
  static const std::optional<double> no;
  static const Ratings ratings = {{1, 2, 3, 3, 2, 1, 4, 1, 2, no, no, no},
                                  {1, 2, 3, 3, 2, 2, 4, 1, 2, 5, no, 3},
                                  {no, 3, 3, 3, 2, 3, 4, 2, 2, 5, 1, no},
                                  {1, 2, 3, 3, 2, 4, 4, 1, 2, 5, 1, no}};
  return ratings;
}

TEST(KrippendorffAlpha, IsAsPublished) {
  const KrippendorffAlpha result = krippendorff_alpha(published());
  EXPECT_EQ(result.pairable, 40);
  EXPECT_NEAR(*result.nominal, 0.743, 0.0005);
  EXPECT_NEAR(*result.ordinal, 0.815, 0.0005);
  EXPECT_NEAR(*result.interval, 0.849, 0.0005);
  EXPECT_NEAR(*result.ratio, 0.797, 0.0005);
}

// Mean disagreement within units over that of any two ratings, rating by rating.
double by_pairs(const Ratings& ratings, const std::function<double(double, double)>& squared) {
  std::vector<std::vector<double>> units(ratings[0].size());
  std::vector<double> all;
  for (std::size_t u = 0; u < units.size(); ++u) {
    for (const auto& rater : ratings) {
      if (rater[u]) units[u].push_back(*rater[u]);
    }
    if (units[u].size() > 1) all.insert(all.end(), units[u].begin(), units[u].end());
  }
  const auto sum = [&](const std::vector<double>& some) {
    double result = 0;
    for (const double a : some) {
      for (const double b : some) result += squared(a, b);
    }
    return result;
  };
  double within = 0;
  for (const auto& unit : units) {
    if (unit.size() > 1) within += sum(unit) / static_cast<double>(unit.size() - 1);
  }
  return 1 - within / (sum(all) / static_cast<double>(all.size() - 1));
}

TEST(KrippendorffAlpha, ComparesPairsWithinUnitsWithAllPairs) {
  study::Rng rng(1, 0, "alpha");
  Ratings ratings(4, std::vector<std::optional<double>>(9));
  for (auto& rater : ratings) {
    for (auto& rating : rater) {
      if (rng.below(3) > 0) rating = 1 + static_cast<double>(rng.below(5));
    }
  }
  const KrippendorffAlpha result = krippendorff_alpha(ratings);
  const auto nominal = [](double a, double b) { return a == b ? 0.0 : 1.0; };
  const auto interval = [](double a, double b) { return (a - b) * (a - b); };
  const auto ratio = [](double a, double b) { return std::pow((a - b) / (a + b), 2); };
  EXPECT_NEAR(*result.nominal, by_pairs(ratings, nominal), 1e-13);
  EXPECT_NEAR(*result.interval, by_pairs(ratings, interval), 1e-13);
  EXPECT_NEAR(*result.ratio, by_pairs(ratings, ratio), 1e-13);
}

// Where each value was given equally often, ranks are as far apart as the values.
TEST(KrippendorffAlpha, OfEvenlyUsedScaleIsTheSameForRanksAndIntervals) {
  const KrippendorffAlpha result = krippendorff_alpha({{1, 2, 3, 4, 1, 2}, {1, 3, 2, 4, 4, 3}});
  EXPECT_EQ(result.pairable, 12);
  EXPECT_NEAR(*result.ordinal, *result.interval, 1e-14);
}

TEST(KrippendorffAlpha, OfPerfectAgreementIsOne) {
  const KrippendorffAlpha result = krippendorff_alpha({{1, 2, 7}, {1, 2, 7}});
  EXPECT_EQ(result.nominal, 1.0);
  EXPECT_EQ(result.ordinal, 1.0);
  EXPECT_EQ(result.ratio, 1.0);
}

TEST(KrippendorffAlpha, IsNotDefinedWhereAllRatingsAreEqualOrNoneHasAPair) {
  EXPECT_FALSE(krippendorff_alpha({{4, 4}, {4, 4}}).nominal);
  EXPECT_FALSE(krippendorff_alpha({{4, 4}, {4, 4}}).interval);
  EXPECT_EQ(krippendorff_alpha({{4, 4}, {4, 4}}).pairable, 4);
  EXPECT_EQ(krippendorff_alpha({{1, {}}, {{}, 2}}).pairable, 0);
  EXPECT_FALSE(krippendorff_alpha({{1, {}}, {{}, 2}}).nominal);
  EXPECT_FALSE(krippendorff_alpha({}).ordinal);
  EXPECT_FALSE(krippendorff_alpha({{}, {}}).ordinal);
  EXPECT_FALSE(krippendorff_alpha({{1, 2, 3}}).ordinal);
}

TEST(KrippendorffAlpha, HasNoRatioOfOppositeValues) {
  const KrippendorffAlpha result = krippendorff_alpha({{-1, 1, 2}, {1, 1, 2}});
  EXPECT_FALSE(result.ratio);
  EXPECT_TRUE(result.interval);
  EXPECT_TRUE(krippendorff_alpha({{0, 1}, {0, 1}}).ratio);
}

TEST(KrippendorffAlpha, DoesNotDependOnTheUnit) {
  const KrippendorffAlpha result = krippendorff_alpha(published());
  for (const double unit : {std::ldexp(1.0, 1000), std::ldexp(1.0, -1000)}) {
    Ratings scaled = published();
    for (auto& rater : scaled) {
      for (auto& rating : rater) {
        if (rating) *rating *= unit;
      }
    }
    EXPECT_EQ(krippendorff_alpha(scaled).interval, result.interval);
    EXPECT_EQ(krippendorff_alpha(scaled).ratio, result.ratio);
  }
}

}  // namespace
}  // namespace promenade::analysis
