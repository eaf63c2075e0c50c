#include "motion/builtin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "motion/distance.h"
#include "motion/gait/feet.h"
#include "motion/motion_space.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

const MotionSet& set_a() {
  static const MotionSet set = *builtin_set("A");
  return set;
}

constexpr int fine = 600;  // samples of a cycle: ten between two phases of the grid
constexpr double degrees = 180 / 3.14159265358979323846;

// The walker at a phase, with its travel put back.
WorldPose walker(const Cycle& cycle, double phase) {
  Pose pose = pose_at(set_a(), cycle, phase);
  const double seconds = seconds_at(set_a(), cycle, phase);
  pose.root += Vector3d(cycle.velocity.x(), 0, cycle.velocity.y()) * seconds;
  return forward_kinematics(set_a().skeleton, pose);
}

Vector3d joint(const WorldPose& world, BodyJoint body) {
  return world.positions.col(set_a().body.joint[body]);
}

Eigen::Quaterniond turn(const WorldPose& world, BodyJoint body) {
  return world.rotations[static_cast<std::size_t>(set_a().body.joint[body])];
}

Vector3d heel(const WorldPose& world) {
  return joint(world, right_ankle) + turn(world, right_ankle) * gait::heel_point;
}

// Degrees that the right toes are up.
double foot_pitch(const WorldPose& world) {
  return std::asin((turn(world, right_ankle) * Vector3d::UnitZ()).y()) * degrees;
}

double knee_flexion(const WorldPose& world) {
  const Vector3d thigh = joint(world, right_knee) - joint(world, right_hip);
  const Vector3d shank = joint(world, right_ankle) - joint(world, right_knee);
  return std::acos(thigh.normalized().dot(shank.normalized())) * degrees;
}

// Largest and smallest of a figure over the right foot's stride: share 0 is its strike.
struct Range {
  double least = INFINITY;
  double most = -INFINITY;
};

template <class Figure>
Range range(const Cycle& cycle, double from, double to, Figure figure) {
  Range found;
  for (int i = 0; i <= fine; ++i) {
    const double share = from + (to - from) * i / fine;
    const double value = figure(walker(cycle, 0.4 + share));
    found = {std::min(found.least, value), std::max(found.most, value)};
  }
  return found;
}

TEST(BuiltinSet, IsThereUnderItsNameOnly) {
  EXPECT_TRUE(builtin_set("A").has_value());
  EXPECT_FALSE(builtin_set("a").has_value());
  EXPECT_FALSE(builtin_set("").has_value());
}

TEST(BuiltinSet, HasTenStylesWithNamesOfTheirOwn) {
  ASSERT_EQ(set_a().size(), 10);
  for (int i = 0; i < 10; ++i) {
    const Cycle& cycle = set_a().cycles[static_cast<std::size_t>(i)];
    EXPECT_EQ(find_cycle(set_a(), cycle.name), i);
    EXPECT_EQ(cycle.source, "generated");
    EXPECT_TRUE(std::is_sorted(cycle.keytimes.begin(), cycle.keytimes.end(), std::less_equal<>()));
  }
}

TEST(BuiltinSet, WalksAtOneSpeedInOneDirection) {
  for (const Cycle& cycle : set_a().cycles) {
    EXPECT_NEAR(cycle.velocity.x(), 0, 1e-12) << cycle.name;
    EXPECT_NEAR(cycle.velocity.y(), gait::walking_speed, 1e-12) << cycle.name;
  }
}

// Where the foot bears: exact on the 60 phases. Between them pose_at interpolates the
// joints on a chord: the arc of the foot about the knee or the hip is missed by
// r a^2 / 8 for an angle a between phases. The quickest stance motion is 7 rad/s at
// the knee before toe off: a = 7 x 0.018 s, r = 0.45 m, which makes 0.9 mm.
TEST(BuiltinSet, KeepsTheBearingPointOfTheFootWithinAMillimetre) {
  for (const Cycle& cycle : set_a().cycles) {
    Vector3d heel_at = heel(walker(cycle, 0.4));
    Vector3d toe_at = joint(walker(cycle, 1.0), right_toe);
    for (int i = 0; i <= fine; ++i) {
      const WorldPose world = walker(cycle, 0.4 + 0.6 * i / fine);
      const bool on_heel = foot_pitch(world) > 0.2;
      const double slide =
          on_heel ? (heel(world) - heel_at).norm() : (joint(world, right_toe) - toe_at).norm();
      EXPECT_LT(slide, 0.001) << cycle.name << " at " << 0.4 + 0.6 * i / fine;
    }
  }
}

TEST(BuiltinSet, NeverSinksIntoTheGround) {
  const auto lowest = [](const WorldPose& world) {
    const Vector3d tip =
        joint(world, right_toe) + turn(world, right_toe) * (gait::toe_tip - Vector3d(0, 0.017, 0));
    return std::min(heel(world).y(), tip.y());
  };
  for (const Cycle& cycle : set_a().cycles) {
    EXPECT_GT(range(cycle, 0, 1, lowest).least, -0.001) << cycle.name;
    EXPECT_GT(range(cycle, 0.68, 0.94, lowest).least, 0.004) << cycle.name;
  }
}

TEST(BuiltinSet, NeverLocksAKnee) {
  for (const Cycle& cycle : set_a().cycles) {
    const Range knee = range(cycle, 0, 1, knee_flexion);
    EXPECT_GT(knee.least, 4) << cycle.name;
    EXPECT_LT(knee.most, 90) << cycle.name;
  }
}

// A velocity that jumps would show as a second difference that grows with the
// sampling rate; at the knees, heel strike makes up to ten times gravity.
TEST(BuiltinSet, MovesWithoutJerksAndClosesItsLoop) {
  for (const Cycle& cycle : set_a().cycles) {
    for (int f = 0; f < set_a().phases; ++f) {
      const auto at = [&](int k) { return seconds_at(set_a(), cycle, k / 60.0); };
      const auto where = [&](int k) { return walker(cycle, k / 60.0).positions; };
      const Eigen::Matrix3Xd after = (where(f + 1) - where(f)) / (at(f + 1) - at(f));
      const Eigen::Matrix3Xd before = (where(f) - where(f - 1)) / (at(f) - at(f - 1));
      const double span = 0.5 * (at(f + 1) - at(f - 1));
      EXPECT_LT((after - before).colwise().norm().maxCoeff() / span, 100) << cycle.name << f;
    }
  }
}

TEST(BuiltinSet, LooksDifferentInEveryStyle) {
  for (const Cycle& a : set_a().cycles) {
    for (const Cycle& b : set_a().cycles) {
      if (a.name >= b.name) continue;
      EXPECT_GT(distance(set_a(), a, b).mean_m, 0.05) << a.name << " and " << b.name;
    }
  }
}

// A threshold of half the median distance between styles must not be won by the
// average, where a trial may start.
TEST(BuiltinSet, LeavesAtLeastEightStylesFarFromItsAverage) {
  std::vector<double> between;
  for (const Cycle& a : set_a().cycles) {
    for (const Cycle& b : set_a().cycles) {
      if (a.name < b.name) between.push_back(distance(set_a(), a, b).mean_m);
    }
  }
  std::sort(between.begin(), between.end());
  const double threshold = 0.5 * between[between.size() / 2];
  const Cycle average = blend(make_motion_space(set_a()), Eigen::VectorXd::Constant(10, 0.1));
  const auto far =
      std::count_if(set_a().cycles.begin(), set_a().cycles.end(), [&](const Cycle& cycle) {
        return distance(set_a(), cycle, average).mean_m > 1.2 * threshold;
      });
  EXPECT_GE(far, 8);
}

TEST(BuiltinSet, AveragesToAWalkThatStaysNearTheGround) {
  const Cycle average = blend(make_motion_space(set_a()), Eigen::VectorXd::Constant(10, 0.1));
  const auto foot = [](const WorldPose& world) {
    return std::min(heel(world).y(), joint(world, right_toe).y() - 0.025);
  };
  const Range stance = range(average, 0, 0.6, foot);
  EXPECT_GT(stance.least, -0.015);
  EXPECT_LT(stance.most, 0.015);
}

TEST(NormalWalk, HasTheFiguresOfNormalGait) {
  const Cycle& cycle = set_a().cycles[0];
  ASSERT_EQ(cycle.name, "normal");
  EXPECT_NEAR(120 / cycle.seconds, 110, 5);                             // cadence
  EXPECT_NEAR(0.5 * cycle.seconds * cycle.velocity.y(), 0.725, 0.025);  // step length
  EXPECT_NEAR(1 - cycle.keytimes[1] / cycle.seconds, 0.60, 0.01);       // stance
  EXPECT_NEAR((cycle.keytimes[2] - cycle.keytimes[1]) / cycle.seconds, 0.10, 0.01);
  const Range height =
      range(cycle, 0, 1, [](const WorldPose& world) { return joint(world, pelvis).y(); });
  EXPECT_NEAR(height.most - height.least, 0.045, 0.01);
  const Range sway =
      range(cycle, 0, 1, [](const WorldPose& world) { return joint(world, pelvis).x(); });
  EXPECT_NEAR(sway.most - sway.least, 0.04, 0.005);
}

TEST(NormalWalk, BendsItsJointsAsPeopleDo) {
  const Cycle& cycle = set_a().cycles[0];
  const auto hip = [](const WorldPose& world) {
    const Vector3d thigh = joint(world, right_knee) - joint(world, right_hip);
    return std::atan2(thigh.z(), -thigh.y()) * degrees;
  };
  EXPECT_NEAR(range(cycle, 0, 1, hip).most, 30, 4);
  EXPECT_NEAR(range(cycle, 0, 1, hip).least, -12, 6);
  EXPECT_LT(knee_flexion(walker(cycle, 0.4)), 12);
  EXPECT_NEAR(range(cycle, 0.08, 0.18, knee_flexion).most, 17.5, 3.5);
  EXPECT_NEAR(range(cycle, 0.25, 0.45, knee_flexion).least, 7, 4);
  EXPECT_NEAR(range(cycle, 0.6, 1, knee_flexion).most, 60, 4);
}

TEST(BuiltinSet, IsTheSameEveryTimeAndEverywhere) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a over values rounded to 1e-6
  const auto add = [&](double value) {
    hash = (hash ^ static_cast<std::uint64_t>(std::llround(value * 1e6))) * 1099511628211u;
  };
  for (const Cycle& cycle : set_a().cycles) {
    for (const double time : cycle.keytimes) add(time);
    for (const double value : cycle.root.reshaped()) add(value);
    for (const double value : cycle.rotations.reshaped()) add(value);
  }
  EXPECT_EQ(hash, 2467690565477578387u);
}

}  // namespace
}  // namespace promenade::motion
