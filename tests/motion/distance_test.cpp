#include "motion/distance.h"

#include <gtest/gtest.h>

#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

// World position of a joint by 4 x 4 matrices from the root down.
Eigen::Vector3d by_matrices(const Skeleton& skeleton, const Pose& pose, int joint) {
  Eigen::Matrix4d world = Eigen::Matrix4d::Identity();
  for (int j = joint; j >= 0; j = skeleton.joints[static_cast<std::size_t>(j)].parent) {
    const Joint& own = skeleton.joints[static_cast<std::size_t>(j)];
    Eigen::Matrix4d local = Eigen::Matrix4d::Identity();
    local.topLeftCorner<3, 3>() = pose.rotations[static_cast<std::size_t>(j)].toRotationMatrix();
    local.topRightCorner<3, 1>() = own.parent < 0 ? pose.root : own.offset;
    world = local * world;
  }
  return world.topRightCorner<3, 1>();
}

TEST(ForwardKinematics, AgreesWithProductsOfMatrices) {
  const MotionSet set = toy_set(1);
  const Pose pose = pose_at(set, set.cycles[0], 0.3);
  const WorldPose world = forward_kinematics(set.skeleton, pose);
  for (int j = 0; j < set.skeleton.size(); ++j) {
    EXPECT_LT((world.positions.col(j) - by_matrices(set.skeleton, pose, j)).norm(), 1e-13) << j;
  }
}

// Eq. 8 letter by letter.
double brute_force(const MotionSet& set, const Cycle& a, const Cycle& b) {
  double sum = 0;
  for (int t = 0; t <= 10; ++t) {
    const Pose x = pose_at(set, a, phase_at(set, a, t / 10.0 * a.seconds));
    const Pose y = pose_at(set, b, phase_at(set, b, t / 10.0 * b.seconds));
    for (const int joint : set.body.joint) {
      sum += (by_matrices(set.skeleton, x, joint) - by_matrices(set.skeleton, y, joint)).norm();
    }
  }
  return sum;
}

TEST(Distance, AgreesWithTheEquationWrittenOut) {
  const MotionSet set = toy_set(2);
  const Distance found = distance(set, set.cycles[0], set.cycles[1]);
  const double sum = brute_force(set, set.cycles[0], set.cycles[1]);
  EXPECT_NEAR(found.sum_m, sum, 1e-12 * sum);
  EXPECT_NEAR(found.mean_m, sum / (11 * 20), 1e-12);
}

TEST(Distance, OfACycleFromItselfIsZeroAndItIsSymmetric) {
  const MotionSet set = toy_set(2);
  EXPECT_EQ(distance(set, set.cycles[0], set.cycles[0]).mean_m, 0);
  EXPECT_EQ(distance(set, set.cycles[0], set.cycles[1]).mean_m,
            distance(set, set.cycles[1], set.cycles[0]).mean_m);
}

TEST(Distance, IgnoresHowFarACycleWalks) {
  const MotionSet set = toy_set(1);
  Cycle faster = set.cycles[0];
  faster.velocity *= 2;
  EXPECT_EQ(distance(set, set.cycles[0], faster).mean_m, 0);
}

TEST(DistanceAtPhases, DoesNotSeeWhenKeytimesCome) {
  const MotionSet set = toy_set(2, 60);
  Cycle late = set.cycles[0];
  for (std::size_t k = 1; k + 1 < late.keytimes.size(); ++k) late.keytimes[k] += 0.05;
  EXPECT_EQ(distance(set, set.cycles[0], late, DistanceTimes::phase).mean_m, 0);
  EXPECT_GT(distance(set, set.cycles[0], late, DistanceTimes::time).mean_m, 1e-3);
}

TEST(DistanceAtPhases, IsTheMeanOverElevenCommonPhases) {
  const MotionSet set = toy_set(2, 60);
  double sum = 0;
  for (int t = 0; t <= 10; ++t) {
    const auto at = [&](const Cycle& cycle) {
      return body_positions(set.body,
                            forward_kinematics(set.skeleton, pose_at(set, cycle, 0.1 * t)));
    };
    sum += (at(set.cycles[0]) - at(set.cycles[1])).colwise().norm().sum();
  }
  const Distance d = distance(set, set.cycles[0], set.cycles[1], DistanceTimes::phase);
  EXPECT_NEAR(d.sum_m, sum, 1e-9);
  EXPECT_NEAR(d.mean_m, sum / 220, 1e-11);
}

}  // namespace
}  // namespace promenade::motion
