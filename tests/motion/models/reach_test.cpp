#include "motion/models/reach.h"

#include <gtest/gtest.h>

#include "motion/models/radial_basis.h"
#include "tests/motion/models/random.h"
#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

using Eigen::VectorXd;

class Reachable : public ::testing::Test {
 protected:
  // Four sliders that know the examples, clamped as in the source.
  ReachProblem sliders() const {
    const WeightsMap map = [this](const VectorXd& at, VectorXd& weights) {
      raw_weights(basis_, at, weights);
      apply_rule(NegativeRule::clamp, weights);
    };
    return {map, {VectorXd::Zero(4), VectorXd::Ones(4)}, VectorXd::Constant(8, 1.0 / 8)};
  }
  DistancePoints points(const VectorXd& weights) const {
    return distance_points(space_.set, blend(space_, weights));
  }
  Reach reach_with(const VectorXd& target, double threshold) const {
    Random random(5);
    return reach(bank_, points(target), sliders(), [&random] { return random.uniform(); },
                 {.threshold_m = threshold, .random_settings = 100});
  }

  MotionSpace space_ = make_motion_space(toy_set(8));
  PoseBank bank_ = make_pose_bank(space_);
  RadialBasis basis_ = fit_radial_basis(Random(3).uniforms(4, 8));
};

TEST_F(Reachable, IsATargetThatTheInterfaceItselfMade) {
  VectorXd target(8);
  sliders().weights(Eigen::Vector4d(0.3, 0.6, 0.45, 0.7), target);
  const Reach result = reach_with(target, 0.06);
  EXPECT_LT(result.best_m, 0.002);
  EXPECT_LT(result.best_m, *std::min_element(result.random_m.begin(), result.random_m.end()));
}

TEST_F(Reachable, IsNoTargetOutsideOfTheSimplex) {
  VectorXd target = VectorXd::Zero(8);
  target(0) = 3;
  target(1) = -2;
  const Reach result = reach_with(target, 0.06);
  EXPECT_GT(result.best_m, 0.02);
}

TEST_F(Reachable, ShareCountsRandomSettingsBelowTheThreshold) {
  const VectorXd target = VectorXd::Unit(8, 2);
  const Reach result = reach_with(target, 0.1);
  const auto below = std::count_if(result.random_m.begin(), result.random_m.end(),
                                   [](double d) { return d < 0.1; });
  EXPECT_EQ(result.random_m.size(), 100u);
  EXPECT_DOUBLE_EQ(result.share_below, static_cast<double>(below) / 100);
}

TEST_F(Reachable, StartIsTheDistanceOfTheStartWeights) {
  const VectorXd target = VectorXd::Unit(8, 2);
  const double direct = distance(points(target), points(VectorXd::Constant(8, 1.0 / 8))).mean_m;
  EXPECT_NEAR(reach_with(target, 0.06).start_m, direct, 1e-9);
}

TEST_F(Reachable, DoesNotDependOnAnythingButItsInput) {
  const VectorXd target = VectorXd::Unit(8, 4);
  const Reach a = reach_with(target, 0.06), b = reach_with(target, 0.06);
  EXPECT_EQ(a.best_m, b.best_m);
  EXPECT_EQ(a.best_at, b.best_at);
}

}  // namespace
}  // namespace promenade::motion
