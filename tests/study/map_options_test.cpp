#include "study/map_options.h"

#include <gtest/gtest.h>

namespace promenade::study {
namespace {

TEST(MapOptions, AreTheStandardsWithoutParameters) {
  const motion::MapOptions options = map_options({});
  EXPECT_EQ(options.heuristic, motion::MapHeuristic::closest);
  EXPECT_EQ(options.nearest, 5);
  EXPECT_EQ(options.components, 0);
  EXPECT_EQ(options.glide_s, 0.15);
}

TEST(MapOptions, FollowTheParametersAndStayInRange) {
  const motion::MapOptions options = map_options({{"heuristic", std::string("weights")},
                                                  {"metric", std::string("mahalanobis")},
                                                  {"nearest", -3.0},
                                                  {"components", 12.0},
                                                  {"glide_s", 1e9}});
  EXPECT_EQ(options.heuristic, motion::MapHeuristic::weights);
  EXPECT_EQ(options.metric, motion::MapMetric::mahalanobis);
  EXPECT_EQ(options.nearest, 1);
  EXPECT_EQ(options.components, 12);
  EXPECT_EQ(options.glide_s, 10);
}

TEST(MapOptions, HeuristicsHaveTheirNames) {
  for (const char* name : {"zero", "closest", "weights", "random"}) {
    EXPECT_EQ(name_of(*map_heuristic(name)), name);
  }
  EXPECT_FALSE(map_heuristic("guess"));
}

}  // namespace
}  // namespace promenade::study
