#include "study/simulated_raters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "motion/models/adjective_pairs.h"
#include "study/adjective_model.h"
#include "study/ratings_csv.h"

namespace promenade::study {
namespace {

TEST(SimulatedRaters, AnswerEveryPairOfEveryMotionOnTheScale) {
  const auto table = simulated_ratings("A");
  ASSERT_TRUE(table);
  EXPECT_TRUE(table->simulated);
  EXPECT_EQ(table->pairs.size(), 41u);
  EXPECT_EQ(table->motions.size(), 10u);
  EXPECT_EQ(table->ratings.size(), 14u * 41 * 10);
  for (std::size_t i = 0; i < table->pairs.size(); ++i) {
    EXPECT_EQ(motion::find_adjective_pair(table->pairs[i]), static_cast<int>(i));
  }
  for (const motion::Rating& rating : table->ratings) {
    EXPECT_TRUE(std::abs(rating.value) <= 2 && rating.value == std::round(rating.value));
  }
}

TEST(SimulatedRaters, SayTheSameForTheSameSeedOnly) {
  const auto csv = [](std::uint64_t seed) {
    return ratings_csv(*simulated_ratings("A", {.raters = 3, .seed = seed}));
  };
  EXPECT_EQ(csv(5), csv(5));
  EXPECT_NE(csv(5), csv(6));
}

TEST(SimulatedRaters, DoNotKnowOtherSets) { EXPECT_FALSE(simulated_ratings("mine")); }

double mean_of(const AdjectiveModel& model, const std::string& pair, const std::string& motion) {
  const auto place = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) - names.begin();
  };
  return model.quantification.mean(place(model.table.pairs, pair),
                                   place(model.table.motions, motion));
}

TEST(SimulatedRaters, SeeWhatTheWalksWereMeantToBe) {
  const AdjectiveModel model = *builtin_adjective_model("A");
  EXPECT_GT(mean_of(model, "sad-happy", "happy"), 1);
  EXPECT_LT(mean_of(model, "sad-happy", "sad"), -1);
  EXPECT_LT(mean_of(model, "old-young", "old"), -1);
  EXPECT_GT(mean_of(model, "calm-excited", "angry"), 1);
}

// [O] kept 27 of the 41 pairs of set A and 29 of set B, in four clusters.
TEST(BuiltInAdjectiveModels, FindTheFourPrimaryParametersOfTheSource) {
  for (const char* set : {"A", "B"}) {
    const AdjectiveModel model = *builtin_adjective_model(set);
    EXPECT_TRUE(model.simulated());
    EXPECT_GE(model.kept_pairs.size(), 20u) << set;
    EXPECT_LE(model.kept_pairs.size(), 36u) << set;
    const std::set<std::string> names(model.names.begin(), model.names.end());
    EXPECT_EQ(names, (std::set<std::string>{"quickness", "clearness", "activeness", "largeness"}))
        << set;
    for (const double agreement : model.name_agreement) EXPECT_GT(agreement, 0.4) << set;
  }
}

}  // namespace
}  // namespace promenade::study
