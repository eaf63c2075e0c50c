#include "analysis/ratings/stimulus_ratings.h"

#include <gtest/gtest.h>

namespace promenade::analysis {
namespace {

TEST(StimulusRatings, AreMeansOverRatersByStimulusAndPair) {
  const auto found = stimulus_ratings({{"p1", "turn", "sad-happy", 2},
                                       {"p2", "turn", "sad-happy", 0},
                                       {"p1", "stop", "slow-fast", -1}});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].stimulus, "stop");
  EXPECT_EQ(found[0].pair, "slow-fast");
  EXPECT_EQ(found[0].raters, 1);
  EXPECT_FALSE(found[0].deviation);
  EXPECT_EQ(found[1].mean, 1);
  EXPECT_DOUBLE_EQ(*found[1].deviation, std::sqrt(2.0));
}

TEST(StimulusRatings, OfOnePersonCountAsOne) {
  const auto found = stimulus_ratings({{"p1", "turn", "sad-happy", 2},
                                       {"p1", "turn", "sad-happy", 1},
                                       {"p2", "turn", "sad-happy", -1}});
  EXPECT_EQ(found[0].raters, 2);
  EXPECT_DOUBLE_EQ(found[0].mean, 0.25);
}

TEST(StimulusRatings, OfNobodyAreNone) { EXPECT_TRUE(stimulus_ratings({}).empty()); }

}  // namespace
}  // namespace promenade::analysis
