// Raters who judge at random make no sliders, whatever passes the thresholds by chance;
// raters who see the motions do.
#include "study/rater_agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/adjective_model.h"
#include "study/rng.h"
#include "study/simulated_raters.h"

namespace promenade::study {
namespace {

// P pairs of N motions by raters who see nothing: value(rng) for each.
template <typename Value>
RatingsTable blind_raters(int raters, int motions, int pairs, std::uint64_t seed, Value value) {
  std::vector<NamedRating> ratings;
  for (int r = 0; r < raters; ++r) {
    Rng rng(seed, static_cast<std::uint64_t>(r), "blind");
    for (int m = 0; m < motions; ++m) {
      for (int p = 0; p < pairs; ++p) {
        ratings.push_back({std::to_string(r), "m" + std::to_string(m),
                           "low" + std::to_string(p) + "-high", value(rng)});
      }
    }
  }
  return make_ratings_table(ratings, {});
}

double anything(Rng& rng) { return static_cast<double>(rng.below(5)) - 2; }

int let_through(int raters, int motions, double (*value)(Rng&)) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto model = make_adjective_model(blind_raters(raters, motions, 41, seed, value), "r");
    count += model.agreement.agrees() ? 1 : 0;
  }
  return count;
}

TEST(RaterAgreement, LetsNoRandomRatersThrough) {
  EXPECT_EQ(let_through(14, 10, anything), 0);
  EXPECT_EQ(let_through(14, 27, anything), 0);
}

// Of two or three raters several pairs pass both thresholds by chance. 1 of 100 is the level;
// more than 5 have a probability of 0.0005.
TEST(RaterAgreement, HoldsItsLevelWherePairsPassByChance) {
  EXPECT_LE(let_through(2, 10, anything), 5);
  EXPECT_LE(let_through(3, 10, anything), 5);
  const auto narrow = [](Rng& rng) { return static_cast<double>(rng.below(3)) - 1; };
  EXPECT_LE(let_through(3, 10, narrow), 5);
}

// All say "rather the right one" of every walk: no pair is dropped, and nothing is told apart.
TEST(RaterAgreement, IsNotThatAllSayTheSameOfEveryMotion) {
  const auto alike = [](Rng& rng) {
    return std::clamp(std::round(1.2 + 0.5 * rng.normal()), -2., 2.);
  };
  const auto model = make_adjective_model(blind_raters(14, 10, 41, 3, alike), "r");
  EXPECT_GT(model.agreement.kept, 35);
  EXPECT_FALSE(model.agreement.agrees());
  EXPECT_LE(let_through(14, 10, alike), 5);
  const auto constant =
      make_adjective_model(blind_raters(14, 10, 41, 3, [](Rng&) { return 2.0; }), "r");
  EXPECT_EQ(constant.agreement.p, 1);
}

TEST(RaterAgreement, LetsAllSimulatedRatersOfTheBuiltInSetsThrough) {
  for (const char* set : {"A", "B"}) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const auto model = make_adjective_model(*simulated_ratings(set, {.seed = seed}), "r");
      ASSERT_TRUE(model.agreement.agrees()) << set << seed << describe(model.agreement);
    }
  }
}

std::vector<NamedRating> seeing(int raters, int motions, int pairs) {
  std::vector<NamedRating> ratings;
  for (int r = 0; r < raters; ++r) {
    for (int m = 0; m < motions; ++m) {
      for (int p = 0; p < pairs; ++p) {
        ratings.push_back({std::to_string(r), "m" + std::to_string(m),
                           "low" + std::to_string(p) + "-high", (m + p) % 2 == 0 ? 2. : -2.});
      }
    }
  }
  return ratings;
}

TEST(RaterAgreement, NeedsAPairForEachSliderUnlessFewerWereAsked) {
  const auto agreement = [](int pairs, int clusters) {
    const motion::QuantificationOptions options{.clusters = clusters};
    return make_adjective_model(make_ratings_table(seeing(6, 6, pairs), {}), "r", options)
        .agreement;
  };
  EXPECT_TRUE(agreement(2, 4).agrees());
  EXPECT_EQ(agreement(2, 4).wanted, 2);
  auto half = seeing(6, 6, 5);
  for (NamedRating& one : half) {
    if (one.pair != "low0-high") one.value /= 4;
  }
  const RaterAgreement found = make_adjective_model(make_ratings_table(half, {}), "r").agreement;
  EXPECT_EQ(found.kept, 1);
  EXPECT_DOUBLE_EQ(found.explained, 1) << "of the pair that is left";
  EXPECT_FALSE(found.agrees());
  EXPECT_NE(describe(found).find("1 of 5 pairs is left (4 never far"), std::string::npos);
}

TEST(RaterAgreement, OfThisTableIsHalfOfItsVariance) {
  // Two raters of two motions. Pair x: 2, -2 by both; all is between the motions. Pair y: 2, 0
  // and 0, 2; nothing is, and sigma is sqrt(2). Each rater can be shuffled in two ways.
  std::vector<NamedRating> ratings = {
      {"1", "a", "x-X", 2}, {"1", "b", "x-X", -2}, {"2", "a", "x-X", 2}, {"2", "b", "x-X", -2},
      {"1", "a", "y-Y", 2}, {"1", "b", "y-Y", 0},  {"2", "a", "y-Y", 0}, {"2", "b", "y-Y", 2}};
  const motion::QuantificationOptions all{.least_extreme = 0, .most_deviation = 3, .clusters = 2};
  const RaterAgreement found =
      make_adjective_model(make_ratings_table(ratings, {}), "r", all).agreement;
  EXPECT_DOUBLE_EQ(found.explained, 0.5);
  EXPECT_EQ(found.p, 1) << "shuffled the other way, y is explained and x is not";
}

TEST(RaterAgreement, OfRatersWithOneMotionEachShufflesThemAll) {
  std::vector<NamedRating> ratings;
  for (int r = 0; r < 16; ++r) {
    ratings.push_back({std::to_string(r), r % 2 == 0 ? "a" : "b", "x-X", r % 2 == 0 ? 2. : -2.});
  }
  EXPECT_TRUE(make_adjective_model(make_ratings_table(ratings, {}), "r").agreement.agrees());
}

TEST(RaterAgreement, LivesWithMissingRatings) {
  std::vector<NamedRating> ratings = seeing(8, 6, 6);
  std::erase_if(ratings, [](const NamedRating& one) {
    return (one.rater.back() + one.motion.back() + one.pair[3]) % 4 == 0;
  });
  const auto model = make_adjective_model(make_ratings_table(ratings, {}), "r");
  EXPECT_TRUE(model.agreement.agrees()) << describe(model.agreement);
}

}  // namespace
}  // namespace promenade::study
