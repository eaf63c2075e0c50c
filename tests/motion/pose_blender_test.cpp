#include "motion/pose_blender.h"

#include <gtest/gtest.h>

#include "motion/builtin.h"
#include "tests/motion/allocations.h"
#include "tests/motion/models/random.h"
#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

using Eigen::VectorXd;

VectorXd random_weights(Random& random, int n) {
  VectorXd weights = random.normals(n, 1);
  weights.array() += (1 - weights.sum()) / n;
  return weights;
}

// Largest difference of positions, and of rotations up to their sign.
double difference(const Pose& a, const Pose& b) {
  double largest = (a.root - b.root).norm();
  for (std::size_t j = 0; j < a.rotations.size(); ++j) {
    const Eigen::Vector4d p = a.rotations[j].coeffs();
    const Eigen::Vector4d q = b.rotations[j].coeffs();
    largest = std::max(largest, std::min((p - q).norm(), (p + q).norm()));
  }
  return largest;
}

void expect_poses_of_blend(const MotionSpace& space, const VectorXd& weights) {
  const PoseBank bank = make_pose_bank(space);
  PoseBlend blender = make_pose_blend(bank);
  set_weights(bank, weights, blender);
  const Cycle cycle = blend(space, weights);
  EXPECT_LE((blender.root - cycle.root).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(blender.timing.keytimes, cycle.keytimes);
  EXPECT_LE((blender.timing.velocity - cycle.velocity).norm(), 1e-12);
  Pose pose;
  for (double phase = -1.3; phase < 2.4; phase += 0.0713) {
    pose_at(bank, blender, phase, pose);
    EXPECT_LE(difference(pose, pose_at(space.set, cycle, phase)), 1e-9) << "at phase " << phase;
  }
}

TEST(APoseBlend, IsThePoseOfTheBlendedCycle) {
  const MotionSpace space = make_motion_space(toy_set(9));
  Random random(1);
  for (int i = 0; i < 5; ++i) expect_poses_of_blend(space, random_weights(random, 9));
}

TEST(APoseBlend, IsExactForLargeTurnsToo) {
  MotionSet set = toy_set(0, 6);
  for (std::uint64_t i = 1; i < 6; ++i) set.cycles.push_back(toy_cycle(set, i, 2.5));
  const MotionSpace space = make_motion_space(set);
  Random random(2);
  for (int i = 0; i < 5; ++i)
    expect_poses_of_blend(space, 2 * random_weights(random, 5).normalized());
}

TEST(APoseBlend, OfAUnitWeightIsThatExample) {
  const MotionSpace space = make_motion_space(toy_set(4));
  for (int i = 0; i < 4; ++i) expect_poses_of_blend(space, VectorXd::Unit(4, i));
}

TEST(APoseBlend, WorksOnTheBuiltInSet) {
  const auto set = builtin_set("A");
  ASSERT_TRUE(set);
  const MotionSpace space = make_motion_space(*set);
  Random random(3);
  expect_poses_of_blend(space, random_weights(random, set->size()));
}

// Up to the sign of its quaternions.
void expect_same_cycle(const Cycle& a, const Cycle& b) {
  ASSERT_EQ(a.keytimes.size(), b.keytimes.size());
  for (std::size_t k = 0; k < a.keytimes.size(); ++k)
    EXPECT_NEAR(a.keytimes[k], b.keytimes[k], 1e-12);
  EXPECT_NEAR(a.seconds, b.seconds, 1e-12);
  EXPECT_LE((a.root - b.root).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE((a.velocity - b.velocity).norm(), 1e-12);
  ASSERT_EQ(a.rotations.cols(), b.rotations.cols());
  const Eigen::RowVectorXd cosine = a.rotations.cwiseProduct(b.rotations).colwise().sum();
  const Eigen::Matrix4Xd turned = b.rotations * cosine.cwiseSign().asDiagonal();
  EXPECT_LE((a.rotations - turned).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(ABlendedCycle, IsTheOneOfTheDefinition) {
  const MotionSpace space = make_motion_space(toy_set(9));
  const PoseBank bank = make_pose_bank(space);
  PoseBlend blender = make_pose_blend(bank);
  Random random(6);
  Cycle cycle;
  for (int i = 0; i < 5; ++i) {
    const VectorXd weights = random_weights(random, 9);
    set_weights(bank, weights, blender);
    blended_cycle(bank, blender, cycle);
    expect_same_cycle(cycle, blend(space, weights));
  }
}

TEST(ABlendedCycle, OfAUnitWeightIsThatExample) {
  const auto set = builtin_set("A");
  ASSERT_TRUE(set);
  const MotionSpace space = make_motion_space(*set);
  const PoseBank bank = make_pose_bank(space);
  PoseBlend blender = make_pose_blend(bank);
  Cycle cycle;
  for (int i = 0; i < set->size(); ++i) {
    set_weights(bank, VectorXd::Unit(set->size(), i), blender);
    blended_cycle(bank, blender, cycle);
    expect_same_cycle(cycle, set->cycles[static_cast<std::size_t>(i)]);
  }
}

// A blend of two lies between them: along the way every joint turns the same way, in
// the shares of the weights, so the distances to both ends add up.
TEST(ABlendedCycle, OfTwoExamplesLiesBetweenThem) {
  const MotionSpace space = make_motion_space(toy_set(2));
  const Cycle& a = space.set.cycles[0];
  const Cycle& b = space.set.cycles[1];
  const double whole = distance(space.set, a, b).mean_m;
  double before = 0;
  for (double share = 0.125; share < 1; share += 0.125) {
    const Cycle mixed = blend(space, Eigen::Vector2d(1 - share, share));
    const double passed = distance(space.set, a, mixed).mean_m;
    const double left = distance(space.set, mixed, b).mean_m;
    EXPECT_GT(passed, before);
    EXPECT_LT(passed, whole);
    EXPECT_LT(passed + left, 1.1 * whole);  // joints move on arcs
    for (std::size_t k = 1; k < mixed.keytimes.size(); ++k) {
      EXPECT_NEAR(mixed.keytimes[k], (1 - share) * a.keytimes[k] + share * b.keytimes[k], 1e-12);
    }
    before = passed;
  }
}

TEST(DistancePointsOfABlend, AreThoseOfItsCycle) {
  const MotionSpace space = make_motion_space(toy_set(7));
  const PoseBank bank = make_pose_bank(space);
  PoseBlend blender = make_pose_blend(bank);
  Random random(4);
  for (int i = 0; i < 5; ++i) {
    const VectorXd weights = random_weights(random, 7);
    set_weights(bank, weights, blender);
    DistancePoints points;
    distance_points(bank, blender, points);
    const DistancePoints expected = distance_points(space.set, blend(space, weights));
    EXPECT_LE((points - expected).cwiseAbs().maxCoeff(), 1e-9);
  }
}

// What a person sees while a slider moves: the phase goes on, only the keytimes change.
TEST(AWalk, DoesNotJumpWhileTheWeightsMove) {
  const MotionSpace space = make_motion_space(toy_set(5, 60));
  const PoseBank bank = make_pose_bank(space);
  PoseBlend blender = make_pose_blend(bank);
  Random random(7);
  const VectorXd from = random_weights(random, 5), to = random_weights(random, 5);
  constexpr int frames = 600;
  constexpr double frame_s = 1.0 / 60;
  double phase = 0;
  double steady = 0;  // largest step between two frames at fixed weights
  double moving = 0;  // the same on the way from one to the other
  Pose before, pose;
  for (int f = 0; f < 3 * frames; ++f) {
    const double share = std::clamp(static_cast<double>(f - frames) / frames, 0.0, 1.0);
    set_weights(bank, from + share * (to - from), blender);
    phase =
        phase_at(bank.set, blender.timing, seconds_at(bank.set, blender.timing, phase) + frame_s);
    pose_at(bank, blender, phase, pose);
    double& largest = share > 0 && share < 1 ? moving : steady;
    if (f > 0) largest = std::max(largest, difference(before, pose));
    std::swap(before, pose);
  }
  // One step of the weights is 1/600 of the way between two walks, which are less than 1 apart.
  EXPECT_LT(moving, steady + 1.0 / frames * 3);
}

TEST(AWalk, StaysWhereItIsWhenOnlyTheWeightsChange) {
  const MotionSpace space = make_motion_space(toy_set(5, 60));
  const PoseBank bank = make_pose_bank(space);
  PoseBlend blender = make_pose_blend(bank);
  Random random(8);
  double phase = 0.37;
  for (int i = 0; i < 100; ++i) {
    set_weights(bank, random_weights(random, 5), blender);
    const double seconds = seconds_at(bank.set, blender.timing, phase);
    phase = phase_at(bank.set, blender.timing, seconds);  // no time passes
  }
  EXPECT_NEAR(phase, 0.37, 1e-12);
}

TEST(APoseBlend, AllocatesNothingOnceItRuns) {
#if PROMENADE_COUNTS_ALLOCATIONS
  const MotionSpace space = make_motion_space(toy_set(7));
  const PoseBank bank = make_pose_bank(space);
  PoseBlend blender = make_pose_blend(bank);
  Random random(5);
  const VectorXd weights = random_weights(random, 7);
  Pose pose;
  DistancePoints points;
  pose_at(bank, blender, 0.5, pose);
  distance_points(bank, blender, points);
  Cycle cycle;
  blended_cycle(bank, blender, cycle);
  const long before = allocations();
  for (int i = 0; i < 100; ++i) {
    set_weights(bank, weights, blender);
    pose_at(bank, blender, 0.01 * i, pose);
    distance_points(bank, blender, points);
    blended_cycle(bank, blender, cycle);
  }
  EXPECT_EQ(allocations(), before);
#else
  GTEST_SKIP() << "the sanitizer brings its own malloc";
#endif
}

}  // namespace
}  // namespace promenade::motion
