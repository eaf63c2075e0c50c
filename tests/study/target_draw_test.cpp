#include "study/target_draw.h"

#include <gtest/gtest.h>

#include <set>

#include "motion/models/map.h"
#include "toy.h"

namespace promenade::study {
namespace {

using motion::DistancePoints;

const StudyBundle& toy_bundle() {
  static const StudyBundle bundle = toy::bundle();
  return bundle;
}

DrawWalk source(DrawModel model) {
  WalkSource made = make_walk_source(model, toy_bundle().space, nullptr);
  EXPECT_EQ(made.problem, "");
  return made.draw;
}

// All joints in one place.
DistancePoints at(double x) { return DistancePoints::Constant(x); }

TEST(FarthestPoints, TakesTheFarthestFromTheStartThenTheFarthestFromAllTaken) {
  const std::vector<DistancePoints> points = {at(1), at(9), at(10), at(-6), at(4)};
  EXPECT_EQ(farthest_points(points, at(0), 4), (std::vector<int>{2, 3, 0, 4}));
  EXPECT_EQ(farthest_points(points, at(0), 9).size(), 5U);
}

TEST(FarthestPoints, TakesNoPointTwiceWhereAllAreOne) {
  const std::vector<int> taken = farthest_points({at(1), at(1), at(1)}, at(0), 3);
  EXPECT_EQ(std::set<int>(taken.begin(), taken.end()).size(), 3U);
}

TEST(WalkSources, GiveWeightsThatSumToOneAndFollowFromTheGenerator) {
  for (const DrawModel model :
       {DrawModel::features, DrawModel::weights, DrawModel::pca, DrawModel::examples}) {
    const DrawWalk draw = source(model);
    Rng one(4, 1, "draw");
    Rng two(4, 1, "draw");
    for (int i = 0; i < 50; ++i) {
      const Eigen::VectorXd weights = draw(one);
      EXPECT_NEAR(weights.sum(), 1, 1e-9) << static_cast<int>(model);
      EXPECT_EQ(weights, draw(two));
    }
  }
}

// Dirichlet(1, 1, 1): mean 1/3, variance 1/18; 4 sigma of 4000 draws.
TEST(WalkSources, DrawSharesUniformlyFromTheSimplex) {
  const DrawWalk draw = source(DrawModel::weights);
  Rng rng(4, 1, "draw");
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3);
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(3);
  for (int i = 0; i < 4000; ++i) {
    const Eigen::VectorXd weights = draw(rng);
    EXPECT_GE(weights.minCoeff(), 0);
    sum += weights;
    squares += weights.cwiseAbs2();
  }
  const double error = 4 * std::sqrt(1.0 / 18 / 4000);
  EXPECT_LT((sum / 4000).cwiseAbs().maxCoeff(), 1.0 / 3 + error);
  EXPECT_GT((sum / 4000).cwiseAbs().minCoeff(), 1.0 / 3 - error);
  EXPECT_NEAR(squares.mean() / 4000, 1.0 / 18 + 1.0 / 9, 0.01);
}

TEST(WalkSources, KeepPointsOfTheMapInsideItsBounds) {
  const motion::Pca pca = motion::principal_components(toy_bundle().space);
  const motion::Minimap map = motion::make_minimap(pca);
  const Eigen::Vector2d radii = motion::valid_radii(map);
  const DrawWalk draw = source(DrawModel::pca);
  Rng rng(4, 1, "draw");
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d point = motion::coordinates_of(pca, draw(rng)).head<2>();
    EXPECT_LE(point.cwiseQuotient(radii).norm(), 1 + 1e-9);
  }
}

TEST(WalkSources, SayWhyThereAreNone) {
  const WalkSource none = make_walk_source(DrawModel::adjectives, toy_bundle().space, nullptr);
  EXPECT_FALSE(none.draw);
  EXPECT_EQ(none.problem, "nobody has rated the motions of this set");
}

double start_of(const Eigen::VectorXd& weights) {
  return start_distance(toy_bundle().space, weights);
}

TEST(DrawTargets, DrawsThoseAgainThatBeginTooNear) {
  const DrawWalk draw = source(DrawModel::weights);
  DrawRules rules{.draws = 20, .kept = 20};
  Rng loose(1, 2, "draw");
  double nearest = 1;
  for (const auto& one : draw_targets(toy_bundle().bank, draw, rules, loose)) {
    nearest = std::min(nearest, start_of(one));
  }
  rules.least_start_m = 0.1;
  EXPECT_LT(nearest, rules.least_start_m);
  Rng strict(1, 2, "draw");
  for (const auto& one : draw_targets(toy_bundle().bank, draw, rules, strict)) {
    EXPECT_GE(start_of(one), rules.least_start_m - 1e-9);
  }
}

double least_distance(const std::vector<Eigen::VectorXd>& walks) {
  double least = 1;
  for (std::size_t i = 0; i < walks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, weights_distance(toy_bundle().space, walks[i], walks[j]));
    }
  }
  return least;
}

TEST(DrawTargets, KeepsThoseThatDifferMost) {
  const DrawWalk draw = source(DrawModel::weights);
  double few = 0;
  double many = 0;
  for (std::uint64_t person = 0; person < 10; ++person) {
    Rng one(1, person, "draw");
    Rng two(1, person, "draw");
    few += least_distance(draw_targets(toy_bundle().bank, draw, {.draws = 4, .kept = 4}, one));
    many += least_distance(draw_targets(toy_bundle().bank, draw, {.draws = 40, .kept = 4}, two));
  }
  EXPECT_GT(many, 2 * few);
}

TEST(UsualLeastStart, LeavesTheAutomaticThresholdAsItIs) {
  const StudyBundle& bundle = toy_bundle();
  const DrawWalk draw = source(DrawModel::weights);
  Task task;
  const double alone = automatic_threshold(bundle.space, task);
  const double least = usual_least_start(bundle.space, bundle.bank, draw, DistanceTimes::time);
  EXPECT_LE(least, alone / start_margin);
  EXPECT_GE(count_far_starts(bundle.bank, draw, DistanceTimes::time, least), tried_starts / 4);
  task.targets.resize(1);
  task.targets[0].draw = draw;
  task.targets[0].least_start_m = least;
  EXPECT_DOUBLE_EQ(automatic_threshold(bundle.space, task), start_margin * least);
}

}  // namespace
}  // namespace promenade::study
