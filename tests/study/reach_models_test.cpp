#include "study/reach_models.h"

#include <gtest/gtest.h>

#include <set>

#include "toy.h"

namespace promenade::study {
namespace {

std::set<std::string> names_of(const ReachModels& models) {
  std::set<std::string> names;
  for (const motion::ControlMap& map : models.maps) names.insert(map.name);
  return names;
}

TEST(ReachModels, OfASetThatNobodyRatedHaveNoAdjectives) {
  const ReachModels models = make_reach_models(toy::bundle());
  EXPECT_EQ(names_of(models), (std::set<std::string>{"features", "labels", "map", "weights"}));
  ASSERT_EQ(models.missing.size(), 1u);
  EXPECT_EQ(models.missing[0].name, "adjectives");
}

AdjectiveModel toy_adjectives(const std::vector<std::string>& motions) {
  std::vector<NamedRating> ratings;
  for (std::size_t m = 0; m < motions.size(); ++m) {
    for (const char* rater : {"a", "b"}) {
      ratings.push_back({rater, motions[m], "slow-fast", 2.0 - static_cast<double>(m)});
      ratings.push_back({rater, motions[m], "sad-happy", m == 1 ? 2.0 : -2.0});
    }
  }
  return make_adjective_model(make_ratings_table(ratings, motions), "test");
}

// The features of the same walks tell at least the two ends of what was rated apart.
TEST(ReachModels, TellAdjectivesFromFeaturesWhereNobodyRated) {
  const StudyBundle bundle = toy::bundle();
  const AdjectiveModel model = toy_adjectives({"near", "side", "far"});
  const auto predicted = predict_adjectives(model, bundle.space.set, bundle.space.set);
  EXPECT_EQ(predicted.names, model.names);
  EXPECT_GE(predicted.primary.minCoeff(), 0);
  EXPECT_LE(predicted.primary.maxCoeff(), 1);
  const ReachModels models = make_reach_models(bundle, predicted);
  ASSERT_NE(find_map(models, "adjectives"), nullptr);
  EXPECT_FALSE(models.adjectives);
  EXPECT_TRUE(models.missing.empty());
}

TEST(ReachModels, CannotTellAdjectivesFromTwoMotions) {
  motion::MotionSet two = toy::motion_set();
  two.cycles.pop_back();
  EXPECT_THROW(predict_adjectives(toy_adjectives({"near", "side"}), two, two), InputError);
}

TEST(ReachModels, TakeTheRatingsTheyAreGiven) {
  const ReachModels models =
      make_reach_models(toy::bundle(), toy_adjectives({"near", "side", "far"}));
  ASSERT_NE(find_map(models, "adjectives"), nullptr);
  EXPECT_EQ(find_map(models, "adjectives")->controls.size(), 2u);
}

TEST(ReachModels, RefuseRatingsOfOtherMotions) {
  const ReachModels models = make_reach_models(toy::bundle(), toy_adjectives({"a", "b", "c"}));
  EXPECT_EQ(find_map(models, "adjectives"), nullptr);
  EXPECT_EQ(models.missing[0].reason, "the ratings are of other motions");
}

TEST(ReachModels, ReachAnExampleWithEveryInterface) {
  const StudyBundle bundle = toy::bundle();
  const Task& task = bundle.study.tasks[0];
  const ReachModels models = make_reach_models(bundle, toy_adjectives({"near", "side", "far"}));
  for (const motion::ControlMap& map : models.maps) {
    const Reach found = reach(models, map, task.targets[0], 0.05, task.distance);
    EXPECT_NEAR(found.best, 0, 1e-6) << map.name;
    EXPECT_NEAR(found.best_example, 0, 1e-9);
    EXPECT_NEAR(found.start, start_distance(bundle.space, *task.targets[0].weights), 1e-9);
  }
}

TEST(ReachModels, GiveTheSameFiguresEveryTime) {
  const StudyBundle bundle = toy::bundle();
  const Task& task = bundle.study.tasks[0];
  const ReachModels models = make_reach_models(bundle);
  const motion::ControlMap& map = *find_map(models, "weights");
  const Reach a = reach(models, map, task.targets[0], 0.05, task.distance);
  const Reach b = reach(models, map, task.targets[0], 0.05, task.distance);
  EXPECT_EQ(a.best, b.best);
  EXPECT_EQ(a.share_below, b.share_below);
  EXPECT_EQ(a.settings, 500);
}

}  // namespace
}  // namespace promenade::study
