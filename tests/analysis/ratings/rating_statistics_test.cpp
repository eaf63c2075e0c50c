#include "analysis/ratings/rating_statistics.h"

#include <gtest/gtest.h>

#include "study/ratings_csv.h"

namespace promenade::analysis {
namespace {

// Three raters; the second one left sad-happy of d out.
study::RatingsTable table() {
  return study::read_ratings_csv("r.csv", R"(rater,motion,pair,value
1,a,slow-fast,2
1,b,slow-fast,0
1,c,slow-fast,-2
1,d,slow-fast,1
2,a,slow-fast,1
2,b,slow-fast,0
2,c,slow-fast,-1
2,d,slow-fast,2
3,a,slow-fast,2
3,b,slow-fast,-1
3,c,slow-fast,-1
3,d,slow-fast,0
1,a,sad-happy,1
1,b,sad-happy,-2
1,c,sad-happy,2
1,d,sad-happy,0
2,a,sad-happy,2
2,b,sad-happy,-1
2,c,sad-happy,1
3,a,sad-happy,-2
3,b,sad-happy,2
3,c,sad-happy,0
3,d,sad-happy,-1
)",
                                 {});
}

// Expected values are from R 4.2: alpha by its coincidence matrix, the intraclass correlations
// from the mean squares of anova(lm(value ~ motion + rater)), cor().
constexpr double near = 1e-12;

TEST(RatingStatistics, HaveKrippendorffsAlphaOverAllAndOfEachPair) {
  const RatingStatistics found = rating_statistics(table());
  EXPECT_NEAR(*found.alpha.ordinal, 0.2234130996517245, near);
  EXPECT_NEAR(*found.alpha.interval, 0.2158415841584158, near);
  EXPECT_NEAR(*found.pairs[0].alpha.ordinal, 0.7448107448107448, near);
  EXPECT_NEAR(*found.pairs[0].alpha.interval, 0.7283950617283951, near);
  EXPECT_NEAR(*found.pairs[1].alpha.ordinal, -0.1642367066895369, near);
  EXPECT_NEAR(*found.pairs[1].alpha.interval, -0.1538461538461537, near);
}

TEST(RatingStatistics, HaveIntraclassCorrelationsOfPairsWithoutGaps) {
  const RatingStatistics found = rating_statistics(table());
  ASSERT_TRUE(found.pairs[0].icc);
  EXPECT_NEAR(*found.pairs[0].icc->agreement, 0.7631578947368420, near);
  EXPECT_NEAR(*found.pairs[0].icc->agreement_mean, 0.9062499999999999, near);
  EXPECT_TRUE(found.pairs[0].no_icc.empty());
  EXPECT_FALSE(found.pairs[1].icc);
  EXPECT_EQ(found.pairs[1].no_icc, "1 of 12 ratings are missing");
}

TEST(RatingStatistics, ShowARaterWhoIsUnlikeTheOthers) {
  const RatingStatistics found = rating_statistics(table());
  ASSERT_EQ(found.raters.size(), 3U);
  EXPECT_NEAR(*found.raters[0].correlation, 0.5670807236297686, near);
  EXPECT_NEAR(*found.raters[1].correlation, 0.4496730838653133, near);
  EXPECT_NEAR(*found.raters[2].correlation, -0.08291849892341731, near);
  EXPECT_EQ(found.raters[1].ratings, 7);
  EXPECT_NEAR(found.raters[1].mean, 4.0 / 7, near);
  EXPECT_NEAR(found.raters[1].deviation, 1.272418020560704, near);
}

TEST(RatingStatistics, CountTheRatingsOfMotions) {
  const RatingStatistics found = rating_statistics(table());
  EXPECT_EQ(found.motions, (std::vector<int>{6, 6, 6, 5}));
  EXPECT_EQ(found.pairs[1].ratings, (std::vector<int>{3, 3, 3, 2}));
}

TEST(RatingStatistics, TakeSeveralRatingsOfOnePersonAsTheirMean) {
  study::RatingsTable twice = table();
  for (motion::Rating one : table().ratings) twice.ratings.push_back(one);
  const RatingStatistics found = rating_statistics(twice);
  EXPECT_EQ(found.motions, (std::vector<int>{6, 6, 6, 5}));
  EXPECT_NEAR(*found.alpha.ordinal, 0.2234130996517245, near);
}

TEST(RatingStatistics, OfOneRaterOrEqualRatingsAreNotDefined) {
  const RatingStatistics one = rating_statistics(
      study::read_ratings_csv("r.csv", "rater,motion,pair,value\n1,a,x-y,1\n1,b,x-y,2\n", {}));
  EXPECT_FALSE(one.alpha.ordinal);
  EXPECT_FALSE(one.pairs[0].icc);
  EXPECT_FALSE(one.raters[0].correlation);
  study::RatingsTable equal = table();
  for (motion::Rating& rating : equal.ratings) rating.value = 1;
  const RatingStatistics same = rating_statistics(equal);
  EXPECT_FALSE(same.alpha.interval);
  EXPECT_EQ(same.pairs[0].no_icc, "all ratings are the same");
  EXPECT_FALSE(same.raters[0].correlation);
}

}  // namespace
}  // namespace promenade::analysis
