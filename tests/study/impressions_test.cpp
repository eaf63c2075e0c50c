#include "study/impressions.h"

#include <gtest/gtest.h>

#include "motion/builtin.h"
#include "motion/models/adjective_pairs.h"
#include "motion/models/adjectives.h"
#include "study/load_study.h"
#include "study/simulate.h"
#include "toy.h"

namespace promenade::study {
namespace {

int pair(const char* name) { return motion::find_adjective_pair(name); }

TEST(Impressions, OfABuiltInSetFollowHowItsWalksWereMeant) {
  const Eigen::MatrixXd felt = impressions_of(*motion::builtin_set("A"), "A");
  const std::vector<motion::StyleCharacter> walks = motion::builtin_characters("A");
  ASSERT_EQ(felt.rows(), 41);
  ASSERT_EQ(felt.cols(), static_cast<Eigen::Index>(walks.size()));
  for (std::size_t i = 0; i < walks.size(); ++i) {
    EXPECT_EQ(felt.col(static_cast<Eigen::Index>(i)), felt_of(walks[i]));
  }
}

// Half a happy and half a sad walk is between the two.
TEST(Impressions, OfAMixtureAreThoseOfItsParts) {
  motion::StyleCharacter happy, sad;
  happy.valence = 0.8;
  happy.pace = 0.2;
  sad.valence = -0.4;
  motion::StyleCharacter half;
  half.valence = 0.2;
  half.pace = 0.1;
  EXPECT_TRUE(felt_of(half).isApprox(0.5 * (felt_of(happy) + felt_of(sad)), 1e-12));
}

TEST(Impressions, NeverReachTheEndsOfTheScale) {
  EXPECT_LT(judged(100), 2.0 + 1e-12);
  EXPECT_EQ(judged(0), 0);
  EXPECT_EQ(judged(-1), -judged(1));
  EXPECT_NEAR(judged(0.01), 0.01, 1e-5);
}

// Of captures nobody knows how they were meant: here the walks of A, as if nobody knew.
TEST(Impressions, OfOtherSetsAreToldFromTheirFeatures) {
  const motion::MotionSet set = *motion::builtin_set("A");
  const Eigen::MatrixXd meant = impressions_of(set, "A");
  const Eigen::MatrixXd told = impressions_of(set, "");
  for (const char* name : {"slow-fast", "sad-happy", "small-large", "calm-excited"}) {
    EXPECT_GT(motion::correlation(meant.row(pair(name)), told.row(pair(name))), 0.7) << name;
  }
}

TEST(Impressions, OfASetWithoutStepsAreNone) {
  motion::MotionSet set = toy::motion_set();
  set.key_phases = {0};
  EXPECT_TRUE((impressions_of(set, "").array() == 0).all());
  EXPECT_TRUE(impressions_of(toy::motion_set(), "A").allFinite());
}

TEST(Impressions, KnowThePairsThatItemsAskFor) {
  Item item;
  item.name = "slow-fast";
  EXPECT_EQ(pair_asked_by(item), pair("slow-fast"));
  item.name = "largeness";
  EXPECT_EQ(pair_asked_by(item), pair("small-large"));
  item.name = "satisfaction";
  EXPECT_EQ(pair_asked_by(item), -1);
  item.name = "slow-fast";
  item.kind = ItemKind::text;
  EXPECT_EQ(pair_asked_by(item), -1);
}

// Mean answers of 20 simulated people to a walk on the short form.
std::map<std::string, double> answers_about(const std::string& targets) {
  const StudyBundle bundle =
      read_study("rated.toml",
                 "[study]\nname = 'rated'\n[[task]]\nname = 'judge'\nkind = 'rate'\ninstrument = "
                 "'impression'\ntargets = [" +
                     targets + "]\n",
                 toy::registry(), load_motion_set);
  std::map<std::string, double> mean;
  constexpr int people = 20;
  for (int i = 0; i < people; ++i) {
    const auto records = simulate_session(bundle, toy::registry(), make_plan(bundle.study, i),
                                          static_cast<std::uint64_t>(i));
    for (const Record& record : records) {
      const auto* answer = std::get_if<Answer>(&record);
      if (answer && answer->trial >= 0) mean[answer->item] += *answer->value / people;
    }
  }
  return mean;
}

TEST(SimulatedParticipants, RateWalksByHowTheyWereMeant) {
  const std::map<std::string, double> happy = answers_about("{example = 'happy'}");
  const std::map<std::string, double> sad = answers_about("{example = 'sad'}");
  EXPECT_GT(happy.at("activeness"), sad.at("activeness") + 1);
  EXPECT_GT(happy.at("largeness"), sad.at("largeness") + 1);
  const std::map<std::string, double> half =
      answers_about("{name = 'half', weights = {happy = 0.5, sad = 0.5}}");
  EXPECT_GT(half.at("activeness"), sad.at("activeness") + 0.3);
  EXPECT_LT(half.at("activeness"), happy.at("activeness") - 0.3);
}

}  // namespace
}  // namespace promenade::study
