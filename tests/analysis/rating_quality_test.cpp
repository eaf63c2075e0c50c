#include "analysis/rating_quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/analysis/toy_log.h"

namespace promenade::analysis {
namespace {

RatedMotion motion(int person, const std::string& target, const std::vector<double>& values,
                   double step_s = 2) {
  RatedMotion one;
  one.person = person;
  one.task = "judge";
  one.target = target;
  one.instrument = "adjectives";
  for (std::size_t i = 0; i < values.size(); ++i) {
    one.items.push_back("item" + std::to_string(i));
    one.answers.push_back(
        {values[i], static_cast<std::int64_t>(1e6 * step_s * static_cast<double>(i))});
  }
  return one;
}

TEST(RatingQuality, CountsPagesThatAreFlaggedForEachPerson) {
  const std::vector<double> line(20, 1);
  std::vector<double> varied;
  for (int i = 0; i < 20; ++i) varied.push_back(i % 5 - 2);
  const RatingQuality quality =
      rating_quality({motion(0, "happy", line), motion(0, "sad", varied),
                      motion(0, "old", line, 0.2), motion(1, "sad", varied, 0.3)});
  ASSERT_EQ(quality.raters.size(), 2U);
  EXPECT_EQ(quality.raters[0].motions, 3);
  EXPECT_EQ(quality.raters[0].straight, 2);
  EXPECT_EQ(quality.raters[0].fast, 1);
  EXPECT_EQ(quality.raters[0].flagged, 2) << "one for both reasons";
  EXPECT_EQ(quality.raters[1].fast, 1);
  EXPECT_EQ(quality.raters[1].straight, 0);
}

TEST(RatingQuality, HoldsPeopleAgainstThemselvesWhereAMotionCameTwice) {
  const RatingQuality quality =
      rating_quality({motion(0, "happy", {-2, 0, 1, 2}), motion(0, "sad", {0, 0, 0, 0}),
                      motion(0, "happy", {-1, 0, 1, 0})});
  const RaterQuality& rater = quality.raters.at(0);
  EXPECT_EQ(rater.repeated, 1);
  EXPECT_EQ(rater.compared, 4);
  EXPECT_DOUBLE_EQ(*rater.mean_difference, 0.75);
  EXPECT_DOUBLE_EQ(*rater.within_one, 0.75);
  // By hand: means 0.25 and 0; sums of products 3, of squares 8.75 and 2.
  EXPECT_NEAR(*rater.correlation, 3 / std::sqrt(17.5), 1e-12);
}

TEST(RatingQuality, ComparesWhatWasAnsweredBothTimesByItem) {
  RatedMotion second = motion(0, "happy", {1, 2});
  second.items = {"item1", "other"};
  const RatingQuality quality = rating_quality({motion(0, "happy", {0, 2}), second});
  EXPECT_EQ(quality.raters.at(0).compared, 1);
  EXPECT_DOUBLE_EQ(*quality.raters[0].mean_difference, 1);
  EXPECT_FALSE(quality.raters[0].correlation) << "one value does not vary";
}

TEST(RatingQuality, SaysNothingWhereNothingCameTwice) {
  const RatingQuality quality =
      rating_quality({motion(0, "happy", {1, 2}), motion(1, "happy", {1, 2})});
  for (const RaterQuality& rater : quality.raters) {
    EXPECT_EQ(rater.repeated, 0);
    EXPECT_FALSE(rater.mean_difference);
  }
  EXPECT_TRUE(rating_quality({}).raters.empty());
}

class RatedMotions : public ::testing::Test {
 protected:
  // Two items of a rate trial: its uuid is "SESSION/NUMBER".
  void answers(const std::string& trial, double value) {
    for (const char* item : {"b", "a"}) {
      study::Statement row(log.database(),
                           "INSERT INTO answer(session, trial, instrument, version, item, value, "
                           "declined, touched, t_us, place) VALUES ('1', ?, 'x', '1', ?, ?, 0, 1, "
                           "5, ?)");
      row.bind(1, trial).bind(2, item).bind(3, value);
      row.bind(4, std::int64_t{item[0] == 'b' ? 1 : 2}).run();
    }
  }
  std::vector<RatedMotion> read() {
    const Log whole = read_log({folder.file("a.db")});
    return read_rated_motions(whole, select(whole, {}));
  }
  TestFolder folder;
  ToyLog log{folder.file("a.db")};
};

TEST_F(RatedMotions, AreReadInTheOrderInWhichTheItemsWereShown) {
  log.session({}).trial({"", "happy"}).trial({"", "sad"}).trial({"labels", "old"});
  for (const char* trial : {"1/1", "1/2", "1/3"}) answers(trial, 1);
  const std::vector<RatedMotion> motions = read();
  ASSERT_EQ(motions.size(), 2U) << "what is made with an interface is no motion to rate";
  EXPECT_EQ(motions[0].items, (std::vector<std::string>{"b", "a"}));
  EXPECT_EQ(motions[1].target, "sad");
}

TEST_F(RatedMotions, LeaveOutPracticeAndWhatWasTakenBack) {
  log.session({}).trial({"", "happy"}).trial({"", "sad"}).trial({"", "old"});
  for (const char* trial : {"1/1", "1/2", "1/3"}) answers(trial, 1);
  log.database().exec("UPDATE trial SET superseded = 1 WHERE uuid = '1/1'");
  log.database().exec("UPDATE trial SET practice = 1 WHERE uuid = '1/2'");
  ASSERT_EQ(read().size(), 1U);
  EXPECT_EQ(read()[0].target, "old");
}

}  // namespace
}  // namespace promenade::analysis
