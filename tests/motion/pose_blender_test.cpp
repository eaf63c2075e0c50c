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
  if (!set) GTEST_SKIP() << "there is no built-in set A in this build";
  const MotionSpace space = make_motion_space(*set);
  Random random(3);
  expect_poses_of_blend(space, random_weights(random, set->size()));
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
  const long before = allocations();
  for (int i = 0; i < 100; ++i) {
    set_weights(bank, weights, blender);
    pose_at(bank, blender, 0.01 * i, pose);
    distance_points(bank, blender, points);
  }
  EXPECT_EQ(allocations(), before);
#else
  GTEST_SKIP() << "the sanitizer brings its own malloc";
#endif
}

}  // namespace
}  // namespace promenade::motion
