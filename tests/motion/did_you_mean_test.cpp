#include "motion/did_you_mean.h"

#include <gtest/gtest.h>

namespace promenade {
namespace {

TEST(EditDistance, CountsLettersThatDiffer) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("macth", "match"), 1);
}

TEST(ClosestName, IsOnlyGivenWhenItIsNear) {
  EXPECT_EQ(closest_name("lables", {"weights", "labels"}), "labels");
  EXPECT_EQ(closest_name("map", {"weights", "labels"}), "");
  EXPECT_EQ(did_you_mean("lables", {"labels"}), "; did you mean \"labels\"?");
  EXPECT_EQ(did_you_mean("x", {}), "");
}

TEST(DidYouMean, TakesNoNoticeOfCaseWhereItIsTold) {
  EXPECT_EQ(closest_name_of_any_case("chanels", {"OFFSET", "CHANNELS"}), "CHANNELS");
  EXPECT_EQ(closest_name_of_any_case("OFSET", {"Offset"}), "Offset");
  EXPECT_EQ(closest_name_of_any_case("x", {}), "");
}

TEST(DidYouMean, CostsLittleWhateverItIsAsked) {
  const std::string longer(1'000'000, 'x');
  EXPECT_EQ(closest_name(longer, {longer + "y"}), "");
  const std::vector<std::string> many(1'000'000, "a name of no use");
  EXPECT_EQ(closest_name("something else", many), "");
}

}  // namespace
}  // namespace promenade
