#include "study/ratings_csv.h"

#include <gtest/gtest.h>

#include "motion/problem.h"

namespace promenade::study {
namespace {

TEST(Ratings, ComeInTheOrderOfThePairsAndTheSet) {
  const RatingsTable table = read_ratings_csv("r.csv",
                                              "value,rater,motion,pair\n"
                                              "1,p,sad,odd-even\n"
                                              "-2,q,happy,narrow-wide\n"
                                              "0.5,p,happy,slow-fast\n",
                                              {"happy", "sad"});
  EXPECT_EQ(table.pairs, (std::vector<std::string>{"slow-fast", "narrow-wide", "odd-even"}));
  EXPECT_EQ(table.raters, 2);
  EXPECT_EQ(table.ratings[0].pair, 2);
  EXPECT_EQ(table.ratings[0].motion, 1);
  EXPECT_EQ(table.ratings[2].rater, 0);
  EXPECT_EQ(table.ratings[2].value, 0.5);
}

TEST(Ratings, NameTheirMotionsWithoutASet) {
  const RatingsTable table =
      read_ratings_csv("r.csv", "rater,motion,pair,value\n1,b,x-y,0\n1,a,x-y,0\n", {});
  EXPECT_EQ(table.motions, (std::vector<std::string>{"a", "b"}));
}

TEST(Ratings, SayAllThatIsWrongWithItsPlace) {
  try {
    read_ratings_csv("r.csv", "rater,motion,pair,value\n1,sda,x-y,3\n1,sad\n", {"sad", "happy"});
    FAIL() << "three problems";
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 3u);
    EXPECT_EQ(error.problems()[0].column, 3);
    EXPECT_NE(error.problems()[0].message.find("did you mean \"sad\""), std::string::npos);
    EXPECT_EQ(to_text(error.problems()[1]),
              "r.csv:2:11: error: the value \"3\" is not a number from -2 to 2");
    EXPECT_EQ(error.problems()[2].line, 3);
  }
}

TEST(Ratings, NeedAHeaderAndARow) {
  EXPECT_THROW(read_ratings_csv("r.csv", "", {}), InputError);
  EXPECT_THROW(read_ratings_csv("r.csv", "rater,motion,pair,value\n", {}), InputError);
  EXPECT_THROW(read_ratings_csv("r.csv", "who,motion,pair,value\na,b,c-d,0\n", {}), InputError);
}

}  // namespace
}  // namespace promenade::study
