#include "motion/models/features.h"

#include <gtest/gtest.h>

#include <set>

#include "motion/builtin.h"
#include "motion/models/centre_of_mass.h"
#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

using Eigen::Vector3d;

// A puppet whose arms and legs are straight, 1 m, and swing like pendulums ahead and
// back; it walks on the spot of a floor that moves.
MotionSet pendulum_set() {
  MotionSet set;
  for (int b = 0; b < body_joint_count; ++b) {
    set.skeleton.joints.push_back({"", body_parent(static_cast<BodyJoint>(b)), Vector3d::Zero()});
    set.body.joint[static_cast<std::size_t>(b)] = b;
  }
  const auto place = [&set](BodyJoint joint, const Vector3d& offset) {
    set.skeleton.joints[static_cast<std::size_t>(joint)].offset = offset;
  };
  place(chest, {0, 0.3, 0});
  place(neck, {0, 0.3, 0});
  place(head, {0, 0.1, 0});
  for (const int side : {1, -1}) {
    const bool l = side > 0;
    place(l ? left_shoulder : right_shoulder, {0.2 * side, 0.25, 0});
    place(l ? left_elbow : right_elbow, {0, -0.5, 0});
    place(l ? left_wrist : right_wrist, {0, -0.5, 0});
    place(l ? left_hip : right_hip, {0.1 * side, 0, 0});
    place(l ? left_knee : right_knee, {0, -0.5, 0});
    place(l ? left_ankle : right_ankle, {0, -0.5, 0});
    place(l ? left_toe : right_toe, {0, 0, 0.2});
  }
  set.skeleton.end_sites.push_back({head, {0, 0.2, 0}});
  return set;
}

constexpr double swing = 0.35;  // radians

Cycle pendulum_cycle(const MotionSet& set) {
  Cycle cycle;
  cycle.seconds = 1.25;
  for (const double phase : set.key_phases) cycle.keytimes.push_back(phase * cycle.seconds);
  cycle.velocity << 0.02, 1.1;
  cycle.root = Eigen::Matrix3Xd::Zero(3, set.phases);
  cycle.rotations = Vector3d::Zero().homogeneous().replicate(1, set.phases * body_joint_count);
  for (int f = 0; f < set.phases; ++f) {
    const double angle = 2 * M_PI * f / set.phases;
    cycle.root.col(f) << 0.03 * std::sin(angle), 1 + 0.02 * std::cos(2 * angle), 0;
    for (const auto& [joint, sign] :
         {std::pair{left_hip, 1}, {right_hip, -1}, {left_shoulder, -1}, {right_shoulder, 1}}) {
      const Eigen::AngleAxisd turn(-sign * swing * std::sin(angle), Vector3d::UnitX());
      cycle.rotations.col(f * body_joint_count + joint) = Eigen::Quaterniond(turn).coeffs();
    }
  }
  return cycle;
}

double feature(const Eigen::VectorXd& values, const char* name) {
  EXPECT_GE(find_feature(name), 0) << name;
  return values(find_feature(name));
}

constexpr double degrees = 180 / M_PI;

TEST(MotionFeatures, HaveFiftyOneDifferentNames) {
  const auto names = feature_names();
  EXPECT_EQ(names.size(), 51u);
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), 51u);
  const auto count = [&names](std::string_view prefix) {
    return std::count_if(names.begin(), names.end(),
                         [prefix](auto n) { return n.starts_with(prefix); });
  };
  EXPECT_EQ(count("sigma_"), 25);
  EXPECT_EQ(count("mu_"), 23);
  EXPECT_EQ(count("v_"), 3);
  EXPECT_EQ(find_feature("sigma_com-velocity_left-right"), 24);
}

TEST(MotionFeatures, OfPendulumsHaveTheDeviationOfASine) {
  const MotionSet set = pendulum_set();
  const Eigen::VectorXd values = motion_features(set, pendulum_cycle(set));
  // A sum of sin^2 over equal steps of a period is exact.
  for (const char* name : {"sigma_left-thigh_front-back", "sigma_right-thigh_front-back",
                           "sigma_left-shin_front-back", "sigma_left-upper-arm_front-back",
                           "sigma_right-forearm_front-back", "sigma_right-foot_front-back"}) {
    EXPECT_NEAR(feature(values, name), degrees * swing / std::sqrt(2), 1e-9) << name;
  }
  EXPECT_NEAR(feature(values, "mu_left-thigh_front-back"), 0, 1e-9);
  EXPECT_NEAR(feature(values, "mu_left-foot_front-back"), 90, 1e-9);
  EXPECT_NEAR(feature(values, "sigma_left-thigh_left-right"), 0, 1e-9);
  EXPECT_NEAR(feature(values, "mu_torso_front-back"), 0, 1e-9);
}

TEST(MotionFeatures, OfAnUprightTrunkThatSwaysAreThoseOfItsCentre) {
  const MotionSet set = pendulum_set();
  Cycle cycle = pendulum_cycle(set);
  cycle.rotations = Vector3d::Zero().homogeneous().replicate(1, set.phases * body_joint_count);
  const Eigen::VectorXd values = motion_features(set, cycle);
  EXPECT_NEAR(feature(values, "sigma_com_left-right"), 0.03 / std::sqrt(2), 1e-12);
  EXPECT_NEAR(feature(values, "sigma_com-position_vertical"), 0.02 / std::sqrt(2), 1e-12);
  // Central differences damp a sine of phase step h by sin(h)/h.
  const double h = 2 * M_PI / set.phases;
  const double rate = 2 * M_PI / cycle.seconds / std::sqrt(2);
  EXPECT_NEAR(feature(values, "sigma_com-velocity_left-right"), 0.03 * rate * std::sin(h) / h,
              1e-12);
  EXPECT_NEAR(feature(values, "sigma_com-velocity_vertical"),
              0.04 * rate * std::sin(2 * h) / (2 * h), 1e-12);
  EXPECT_NEAR(feature(values, "sigma_com-velocity_front-back"), 0, 1e-12);
}

TEST(MotionFeatures, HoldTheTravelAndTheDuration) {
  const MotionSet set = pendulum_set();
  const Eigen::VectorXd values = motion_features(set, pendulum_cycle(set));
  EXPECT_NEAR(feature(values, "mu_com-velocity_front-back"), 1.1, 1e-12);
  EXPECT_NEAR(feature(values, "mu_com-velocity_left-right"), 0.02, 1e-12);
  EXPECT_EQ(feature(values, "v_motion-duration"), 1.25);
}

TEST(MotionFeatures, MeasureTheStepWhenTheRightFootComesOn) {
  const MotionSet set = pendulum_set();
  const Eigen::VectorXd values = motion_features(set, pendulum_cycle(set));
  const double angle = swing * std::sin(2 * M_PI * set.key_phases[1]);
  EXPECT_NEAR(feature(values, "v_step-length_front-back"), -2 * std::sin(angle), 1e-9);
  EXPECT_NEAR(feature(values, "v_step-length_left-right"), 0.2, 1e-12);
}

TEST(MotionFeatures, WeighPhasesByTheirTime) {
  const MotionSet set = pendulum_set();
  Cycle cycle = pendulum_cycle(set);
  for (int f = 0; f < set.phases; ++f) cycle.root(1, f) = f >= 24 && f < 30 ? 2 : 1;
  cycle.keytimes = {0, 0.4, 0.9, 1.2, 1.25};  // phases 24 to 30 take 0.5 s
  const double high = feature(motion_features(set, cycle), "mu_com-position_vertical");
  cycle.root.row(1).setOnes();
  const double low = feature(motion_features(set, cycle), "mu_com-position_vertical");
  // Trapezoids: half a phase of 0.4/24 s before and half of 0.5/6 s less after.
  EXPECT_NEAR(high - low, (0.5 + 0.5 * (0.4 / 24 - 0.5 / 6)) / 1.25, 1e-12);
}

TEST(MotionFeatures, FollowAnArmAroundTheCircle) {
  const MotionSet set = pendulum_set();
  Cycle cycle = pendulum_cycle(set);
  for (int f = 0; f < set.phases; ++f) {
    const double angle = M_PI - 0.2 * std::sin(2 * M_PI * f / set.phases);
    const Eigen::AngleAxisd turn(angle, Vector3d::UnitX());
    cycle.rotations.col(f * body_joint_count + left_shoulder) = Eigen::Quaterniond(turn).coeffs();
  }
  const Eigen::VectorXd values = motion_features(set, cycle);
  EXPECT_NEAR(feature(values, "sigma_left-upper-arm_front-back"), degrees * 0.2 / std::sqrt(2),
              1e-9);
  EXPECT_NEAR(std::abs(feature(values, "mu_left-upper-arm_front-back")), 180, 1e-9);
}

TEST(MotionFeatures, LeanLeftAndAheadArePositive) {
  const MotionSet set = pendulum_set();
  Cycle cycle = pendulum_cycle(set);
  const Eigen::Quaterniond lean(Eigen::AngleAxisd(0.3, Vector3d::UnitX()));
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(-0.2, Vector3d::UnitZ()));
  for (int f = 0; f < set.phases; ++f) {
    cycle.rotations.col(f * body_joint_count + neck) = lean.coeffs();
    cycle.rotations.col(f * body_joint_count + chest) = tilt.coeffs();
  }
  const Eigen::VectorXd values = motion_features(set, cycle);
  EXPECT_NEAR(feature(values, "mu_head_front-back"),
              degrees * std::atan2(std::sin(0.3), std::cos(0.2) * std::cos(0.3)), 1e-9);
  EXPECT_GT(feature(values, "mu_torso_left-right"), 0);
}

TEST(BodySegments, HaveTheMassOfOneBody) {
  double mass = 0;
  for (const Segment& segment : body_segments()) mass += segment.mass;
  EXPECT_NEAR(mass, 1, 1e-15);
  EXPECT_EQ(body_segments().size(), 14u);
}

TEST(TheCentreOfMass, MovesWithTheBody) {
  BodyPoints points = BodyPoints::Random();
  const Vector3d shift(1, -2, 3);
  const Vector3d before = centre_of_mass(points);
  points.colwise() += shift;
  EXPECT_LE((centre_of_mass(points) - before - shift).norm(), 1e-13);
}

TEST(TheCentreOfMass, IsWhereASegmentPutsIt) {
  BodyPoints points = BodyPoints::Zero();
  points.col(left_knee) << 0, 1, 0;  // thigh to its distal end, shank from its proximal
  EXPECT_NEAR(centre_of_mass(points).y(), .1416 * .4095 + .0433 * (1 - .4395), 1e-15);
}

TEST(MotionFeatures, OfTheBuiltInSetAreThoseOfPeople) {
  const auto set = builtin_set("A");
  ASSERT_TRUE(set);
  const Eigen::MatrixXd values = motion_features(*set);
  EXPECT_TRUE(values.allFinite());
  for (int i = 0; i < set->size(); ++i) {
    const Eigen::VectorXd one = values.col(i);
    EXPECT_GT(feature(one, "v_step-length_front-back"), 0.2)
        << set->cycles[static_cast<std::size_t>(i)].name;
    EXPECT_LT(feature(one, "v_step-length_front-back"), 1.1);
    EXPECT_NEAR(feature(one, "mu_com-position_vertical"), 0.95, 0.15);
    EXPECT_LT(feature(one, "sigma_com-position_vertical"), 0.06);
  }
}

}  // namespace
}  // namespace promenade::motion
