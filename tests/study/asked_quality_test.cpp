#include "study/asked_quality.h"

#include <gtest/gtest.h>

#include "motion/problem.h"
#include "toy.h"

namespace promenade::study {
namespace {

Target asking(const std::string& name, const std::string& pair = "") {
  Target target;
  target.name = name;
  target.pair = pair;
  return target;
}

AdjectiveModel model() {
  return make_adjective_model(make_ratings_table({{"a", "near", "sad-happy", 2},
                                                  {"a", "far", "sad-happy", -1},
                                                  {"b", "near", "sad-happy", 1},
                                                  {"b", "far", "sad-happy", -1},
                                                  {"a", "near", "old-young", 1}},
                                                 {"near", "far"}),
                              "test");
}

TEST(AskedPair, HasTheNameOfTheQualityAsAPole) {
  const RatingsTable table = model().table;
  const auto happy = asked_pair(table.pairs, asking("happy"));
  ASSERT_TRUE(happy);
  EXPECT_EQ(table.pairs[static_cast<std::size_t>(happy->pair)], "sad-happy");
  EXPECT_FALSE(happy->left);
  EXPECT_TRUE(asked_pair(table.pairs, asking("sad"))->left);
  Target written = asking("q1");
  written.quality["en"] = "young";
  EXPECT_EQ(table.pairs[static_cast<std::size_t>(asked_pair(table.pairs, written)->pair)], "old-young");
  EXPECT_FALSE(asked_pair(table.pairs, asking("brisk")));
}

TEST(AskedPair, IsTheOneThatTheStudyNames) {
  const RatingsTable table = model().table;
  const auto turned = asked_pair(table.pairs, asking("happy", "young-old"));
  ASSERT_TRUE(turned);
  EXPECT_EQ(table.pairs[static_cast<std::size_t>(turned->pair)], "old-young");
  EXPECT_TRUE(turned->left);
  EXPECT_FALSE(asked_pair(table.pairs, asking("happy", "dim-sharp"))) << "nobody rated it";
}

TEST(AskedRatings, PointTowardsTheAskedWord) {
  const AdjectiveModel rated = model();
  const auto sad = asked_pair(rated.table.pairs, asking("sad"));
  const Eigen::VectorXd ratings = asked_ratings(rated, *sad);
  EXPECT_EQ(ratings, Eigen::Vector2d(-1.5, 1));
  const auto young = asked_pair(rated.table.pairs, asking("young"));
  EXPECT_TRUE(std::isnan(asked_ratings(rated, *young)(1)));
}

StudyBundle with_quality(const std::string& quality) {
  std::string text = toy::study_text();
  const std::string jolly = "{ name = \"jolly\" }";
  text.replace(text.find(jolly), jolly.size(), quality);
  return toy::bundle(text);
}

TEST(AskedPair, IsReadFromTheStudy) {
  const auto pair_of = [](const StudyBundle& bundle) {
    return bundle.study.tasks[1].targets[0].pair;
  };
  EXPECT_EQ(pair_of(with_quality(R"({ name = "jolly", pair = "sad-happy" })")), "sad-happy");
  EXPECT_EQ(pair_of(with_quality(R"({ name = "jolly", pair = "happy-sad" })")), "happy-sad");
  EXPECT_EQ(pair_of(with_quality(R"({ name = "jolly" })")), "");
}

TEST(AskedPair, ThatNobodyRatesIsAnError) {
  for (const char* pair : {"sad-hapy", "sad", "", "-", "happy-", "-sad", "sad happy"}) {
    try {
      with_quality(std::string(R"({ name = "jolly", pair = ")") + pair + "\" }");
      ADD_FAILURE() << pair;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("nobody rates the pair of adjectives"),
                std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace promenade::study
