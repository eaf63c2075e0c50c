#include "app/target_reports.h"

#include <gtest/gtest.h>

namespace promenade::app {
namespace {

// Of two interfaces, whose share of settings below the threshold is given.
TargetReport report(double share, double other_share) {
  TargetReport made;
  made.threshold_m = 0.02;
  made.reaches.push_back({"map", {.best = 0.01, .share_below = share, .settings = 500}});
  made.reaches.push_back({"labels", {.best = 0.03, .share_below = other_share, .settings = 500}});
  return made;
}

TEST(TargetReports, TellWhatIsOutOfReach) {
  EXPECT_FALSE(is_out_of_reach(report(0, 0), 0));
  EXPECT_TRUE(is_out_of_reach(report(0, 0), 1));
}

TEST(TargetReports, TellWhatIsMetByChance) {
  EXPECT_TRUE(is_favoured(report(0.2, 0.05), 0));
  EXPECT_FALSE(is_favoured(report(0.2, 0.05), 1));
  EXPECT_FALSE(is_favoured(report(0.1, 0.05), 0));
  // None of 500 stands for less than one of them.
  EXPECT_FALSE(is_favoured(report(0.002, 0), 0));
  EXPECT_TRUE(is_favoured(report(0.01, 0), 0));
}

TEST(TargetReports, TellNothingWithoutAThreshold) {
  TargetReport without = report(0.5, 0);
  without.threshold_m.reset();
  EXPECT_FALSE(is_out_of_reach(without, 1));
  EXPECT_FALSE(is_favoured(without, 0));
}

}  // namespace
}  // namespace promenade::app
