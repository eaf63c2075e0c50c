#include "study/ratings.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "motion/problem.h"
#include "study/schema.h"
#include "study/sqlite.h"

namespace promenade::study {
namespace {

// A database as the questionnaire leaves it: a trial for each motion, an answer for each
// pair.
class Rated : public ::testing::Test {
 protected:
  Rated()
      : file_(std::filesystem::temp_directory_path() /
              ("promenade_ratings_" + std::to_string(::getpid()) + ".db")) {
    std::filesystem::remove(file_);
    database_.emplace(file_.string(), Database::Mode::create);
    create_tables(*database_);
    database_->exec("INSERT INTO study VALUES ('s', 'q', '1', '', 'h', '1', '2026', NULL)");
    add_person("p1", false);
    add_person("p2", false);
  }
  ~Rated() override { std::filesystem::remove(file_); }

  void add_person(const std::string& name, bool simulated) {
    database_->exec("INSERT INTO participant VALUES ('" + name + "', '" + name + "')");
    database_->exec(
        "INSERT INTO session(uuid, study, participant, station, seed, sequence, "
        "language, started_utc, outcome, simulated, pilot, machine) VALUES ('" +
        name + "', 's', '" + name + "', '1', 1, 0, 'en', '" + name + "', 'finished', " +
        (simulated ? "1" : "0") + ", 0, '{}')");
    for (const char* motion : {"happy", "sad"}) {
      database_->exec(
          "INSERT INTO trial(uuid, session, position, block, practice, task, "
          "interface, target, started_us) VALUES ('" +
          name + motion + "', '" + name + "', 1, 1, 0, 'rate', '', '" + motion + "', 0)");
    }
  }
  void answer(const std::string& person, const std::string& motion, const std::string& item,
              double value, int t_us = 0, const std::string& instrument = "adjectives") {
    Statement insert(*database_,
                     "INSERT INTO answer(session, trial, instrument, version, item, value, "
                     "declined, touched, t_us) VALUES (?,?,?,'1',?,?,0,1,?)");
    insert.bind(1, person).bind(2, person + motion).bind(3, instrument).bind(4, item);
    insert.bind(5, value).bind(6, t_us).run();
  }
  RatingsTable table(const RatingSelection& selection = {}) const {
    return read_database_ratings(file_.string(), selection).table;
  }
  std::string message(const RatingSelection& selection = {}) const {
    try {
      read_database_ratings(file_.string(), selection);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path file_;
  std::optional<Database> database_;
};

TEST_F(Rated, AreTheAnswersAboutPairsOfAdjectives) {
  answer("p1", "happy", "slow-fast", 2);
  answer("p2", "happy", "slow-fast", -1);
  answer("p2", "sad", "sad-happy", -2);
  answer("p2", "sad", "satisfaction", 7);  // a rating of something else
  const RatingsTable found = table();
  EXPECT_EQ(found.raters, 2);
  EXPECT_EQ(found.motions, (std::vector<std::string>{"happy", "sad"}));
  EXPECT_EQ(found.pairs, (std::vector<std::string>{"slow-fast", "sad-happy"}));
  EXPECT_EQ(found.ratings.size(), 3u);
  EXPECT_FALSE(found.simulated);
}

TEST_F(Rated, CountTheLastAnswerToAnItem) {
  answer("p1", "happy", "slow-fast", 2, 1000);
  answer("p1", "happy", "slow-fast", -1, 5000);
  ASSERT_EQ(table().ratings.size(), 1u);
  EXPECT_EQ(table().ratings[0].value, -1);
}

// A motion that came twice in a session has two ratings, which a model averages.
TEST_F(Rated, CountBothRatingsOfAMotionThatCameTwice) {
  answer("p1", "happy", "slow-fast", 2);
  database_->exec(
      "INSERT INTO trial(uuid, session, position, block, practice, task, interface, target, "
      "started_us) VALUES ('p1again', 'p1', 2, 1, 0, 'rate', '', 'happy', 0)");
  answer("p1", "again", "slow-fast", -1, 9000);
  const RatingsTable found = table();
  ASSERT_EQ(found.ratings.size(), 2u);
  EXPECT_EQ(found.ratings[0].value + found.ratings[1].value, 1);
  const motion::Quantification model = motion::quantify(found.ratings, 1, 2);
  EXPECT_EQ(model.mean(0, 0), 0.5);
}

TEST_F(Rated, LeaveOutWhatWasTakenBack) {
  answer("p1", "happy", "slow-fast", 2);
  answer("p1", "sad", "slow-fast", -2);
  database_->exec("UPDATE trial SET superseded = 1 WHERE uuid = 'p1happy'");
  ASSERT_EQ(table().ratings.size(), 1u);
  EXPECT_EQ(table().ratings[0].value, -2);
}

TEST_F(Rated, LeaveSimulatedPeopleOutUnlessTheyAreAskedFor) {
  add_person("s1", true);
  answer("s1", "happy", "slow-fast", 2);
  EXPECT_NE(message().find("--include-simulated"), std::string::npos);
  EXPECT_TRUE(table({true, false, ""}).simulated);
  answer("p1", "happy", "slow-fast", 1);
  EXPECT_EQ(table().raters, 1);
  EXPECT_FALSE(table().simulated);
}

TEST_F(Rated, CanBeOfItemsOfOnesOwn) {
  answer("p1", "happy", "cold-warm", 1, 0, "mine");
  EXPECT_NE(message().find("holds no ratings"), std::string::npos);
  EXPECT_EQ(table({false, false, "mine"}).pairs, std::vector<std::string>{"cold-warm"});
}

TEST_F(Rated, MustLieOnTheScale) {
  answer("p1", "happy", "slow-fast", 5);
  answer("p1", "sad", "slow-fast", -3);
  EXPECT_NE(message().find("the answer 5 to \"slow-fast\" about \"happy\""), std::string::npos);
  EXPECT_NE(message().find("about \"sad\" is not from -2 to 2"), std::string::npos);
}

}  // namespace
}  // namespace promenade::study
