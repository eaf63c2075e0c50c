#include "motion/foot_plant.h"

#include <gtest/gtest.h>

#include "motion/foot_measures.h"
#include "tests/motion/walker.h"

namespace promenade::motion {
namespace {

MotionSet walkers() { return builtin_set("A").value(); }

double slide(const MotionSet& set, const Cycle& cycle) {
  return std::max(stance_slide_m(set, cycle, Side::left), stance_slide_m(set, cycle, Side::right));
}

TEST(StanceSlide, IsTheWayThatTheGroundIsTooFast) {
  const MotionSet set = walkers();
  Cycle sliding = set.cycles[0];
  sliding.velocity.y() += 0.2;
  const double stance = sliding.keytimes[4] - sliding.keytimes[1];
  EXPECT_NEAR(stance_slide_m(set, sliding, Side::right), 0.2 * stance, 0.3 * 0.2 * stance);
}

// By construction a generated foot stands; what is left is that its heel is guessed.
TEST(StanceSlide, OfGeneratedFeetIsAFewMillimetres) {
  for (const char* name : {"A", "B", "N"}) {
    const MotionSet set = builtin_set(name).value();
    for (const Cycle& cycle : set.cycles) EXPECT_LT(slide(set, cycle), 0.004) << cycle.name;
  }
}

TEST(PlantFeet, HoldsFeetThatSlide) {
  const MotionSet set = walkers();
  Cycle cycle = set.cycles[0];
  cycle.velocity.y() *= 1.07;
  EXPECT_GT(slide(set, cycle), 0.03);
  plant_feet(set, cycle);
  EXPECT_LT(slide(set, cycle), 0.008);
}

TEST(PlantFeet, KeepsBonesAndTheLoop) {
  const MotionSet set = walkers();
  Cycle cycle = set.cycles[1];
  cycle.velocity.y() *= 1.05;
  plant_feet(set, cycle);
  EXPECT_LT((cycle.rotations.colwise().norm().array() - 1).abs().maxCoeff(), 1e-12);
  EXPECT_LT(seam(set, cycle).position_m, 1e-4);
}

TEST(PlantFeet, LiftsAFootThatSinks) {
  const MotionSet set = walkers();
  Cycle cycle = set.cycles[0];
  for (int f = 30; f <= 34; ++f) {
    cycle.root(1, f) -= 0.03 * std::pow(std::sin(M_PI * (f - 29) / 6.0), 2);
  }
  EXPECT_GT(penetration_m(set, cycle), 0.02);
  plant_feet(set, cycle);
  EXPECT_LT(penetration_m(set, cycle), 0.004);
  EXPECT_LT(slide(set, cycle), 0.008);
}

TEST(PlantFeet, StandsBothFeetAtOneHeight) {
  const MotionSet set = walkers();
  Cycle cycle = set.cycles[0];
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()));
  const int joints = set.skeleton.size();
  for (int f = 0; f < set.phases; ++f) {
    auto pelvis_turn = cycle.rotations.col(f * joints);
    pelvis_turn = (tilt * Eigen::Quaterniond(Eigen::Vector4d(pelvis_turn))).coeffs();
  }
  const auto apart = [&] {
    return std::abs(toe_level(set, cycle, Side::left) - toe_level(set, cycle, Side::right));
  };
  EXPECT_GT(apart(), 0.01);
  plant_feet(set, cycle);
  EXPECT_LT(apart(), 0.002);
}

TEST(Seam, ShowsAJumpInOneJoint) {
  const MotionSet set = walkers();
  Cycle cycle = set.cycles[0];
  const double smooth = seam(set, cycle).gap_m;
  cycle.root.col(0).y() += 0.05;
  EXPECT_GT(seam(set, cycle).gap_m, smooth + 0.04);
}

TEST(MoveFoot, BringsTheAnkleWhereItIsWanted) {
  const MotionSet set = walkers();
  const std::vector<Pose> poses = {pose_at(set, set.cycles[0], 0.2)};
  const int ankle = set.body.joint[left_ankle];
  const WorldPose before = forward_kinematics(set.skeleton, poses[0]);
  const FootTarget target{before.positions.col(ankle) + Eigen::Vector3d(0.02, 0.03, -0.05),
                          before.rotations[static_cast<std::size_t>(ankle)]};
  Pose pose = poses[0];
  move_foot(set.skeleton, set.body, Side::left,
            knee_axis(set.skeleton, set.body, Side::left, poses), target, pose);
  const WorldPose after = forward_kinematics(set.skeleton, pose);
  EXPECT_LT((after.positions.col(ankle) - target.ankle).norm(), 1e-12);
  EXPECT_LT(after.rotations[static_cast<std::size_t>(ankle)].angularDistance(target.rotation),
            1e-7);
}

}  // namespace
}  // namespace promenade::motion
