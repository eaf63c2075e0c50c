#include "motion/models/control_maps.h"

#include <gtest/gtest.h>

#include "tests/motion/models/random.h"
#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

using Eigen::VectorXd;

VectorXd setting(const Box& box, Random& random) {
  const VectorXd share = random.uniforms(box.size(), 1);
  return box.low + share.cwiseProduct(box.high - box.low);
}

VectorXd weights_of(const ControlMap& map, const VectorXd& at) {
  VectorXd weights(map.problem.start.size());
  map.problem.weights(at, weights);
  return weights;
}

class ControlMaps : public ::testing::Test {
 protected:
  double reached(const ControlMap& map, const VectorXd& target) const {
    Random random(9);
    PoseBlend blend = make_pose_blend(bank_);
    set_weights(bank_, target, blend);
    DistancePoints points;
    distance_points(bank_, blend, points);
    return reach(bank_, points, problem_of(map, target), [&] { return random.uniform(); },
                 {.random_settings = 50})
        .best_m;
  }

  MotionSpace space_ = make_motion_space(toy_set(8));
  PoseBank bank_ = make_pose_bank(space_);
  ControlMap map_ = *map_controls(space_, {.components = 7});
  ControlMap labels_ = label_controls(space_.set);
  ControlMap sliders_ = slider_controls("adjectives", {"a", "b", "c"}, Random(4).uniforms(3, 8));
  ControlMap weights_ = weight_controls(space_.set);
};

TEST_F(ControlMaps, GiveWeightsThatSumToOneEverywhere) {
  Random random(5);
  for (const ControlMap* map : {&map_, &sliders_, &weights_}) {
    EXPECT_EQ(static_cast<int>(map->controls.size()), map->problem.box.size());
    for (int i = 0; i < 50; ++i) {
      EXPECT_NEAR(weights_of(*map, setting(map->problem.box, random)).sum(), 1, 1e-9) << map->name;
    }
  }
}

TEST_F(ControlMaps, OfTheMapGiveAnExampleAtItsDot) {
  for (int i = 0; i < 8; ++i) {
    const VectorXd weights = weights_of(map_, map_.problem.guesses[static_cast<std::size_t>(i)]);
    EXPECT_LE((weights - VectorXd::Unit(8, i)).norm(), 1e-9);
  }
}

TEST_F(ControlMaps, OfSlidersGiveAnExampleAtItsParameters) {
  for (int i = 0; i < 8; ++i) {
    const VectorXd weights =
        weights_of(sliders_, sliders_.problem.guesses[static_cast<std::size_t>(i)]);
    EXPECT_LE((weights - VectorXd::Unit(8, i)).norm(), 1e-9);
  }
}

TEST_F(ControlMaps, OfWeightsShowTheAverageWhenNothingIsAskedFor) {
  EXPECT_EQ(weights_of(weights_, VectorXd::Zero(8)), VectorXd::Constant(8, 1.0 / 8));
  EXPECT_EQ(weights_of(weights_, VectorXd::Ones(8)), VectorXd::Constant(8, 1.0 / 8));
}

TEST_F(ControlMaps, OfLabelsReachExamplesAndNothingElse) {
  EXPECT_NEAR(reached(labels_, VectorXd::Unit(8, 3)), 0, 1e-9);
  const VectorXd half = 0.5 * (VectorXd::Unit(8, 3) + VectorXd::Unit(8, 5));
  EXPECT_GT(reached(labels_, half), 0.02);
  EXPECT_LT(reached(weights_, half), 1e-6);  // the guess is the target itself
}

TEST_F(ControlMaps, ReachEveryExample) {
  for (const ControlMap* map : {&map_, &sliders_, &weights_}) {
    EXPECT_LT(reached(*map, VectorXd::Unit(8, 2)), 1e-6) << map->name;
  }
}

TEST(FeatureSliders, RunFromZeroToOneOverTheSet) {
  const Eigen::MatrixXd parameters = feature_sliders(toy_set(6, 60)).parameters;
  ASSERT_EQ(parameters.rows(), 4);
  EXPECT_EQ(parameters.rowwise().minCoeff(), Eigen::VectorXd::Zero(4));
  EXPECT_EQ(parameters.rowwise().maxCoeff(), Eigen::VectorXd::Ones(4));
}

}  // namespace
}  // namespace promenade::motion
