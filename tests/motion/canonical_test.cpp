#include "motion/canonical.h"

#include <gtest/gtest.h>

#include "tests/motion/toy_set.h"

namespace promenade::motion {
namespace {

TEST(TimeWarp, PutsKeytimesOnCommonPhasesAndComesBack) {
  const MotionSet set = toy_set(1);
  const Cycle& cycle = set.cycles[0];
  for (std::size_t k = 0; k < set.key_phases.size(); ++k) {
    EXPECT_NEAR(seconds_at(set, cycle, set.key_phases[k]), cycle.keytimes[k], 1e-15);
  }
  for (double phase = -1.3; phase < 2.5; phase += 0.17) {
    EXPECT_NEAR(phase_at(set, cycle, seconds_at(set, cycle, phase)), phase, 1e-14);
  }
  EXPECT_NEAR(seconds_at(set, cycle, 1.25), cycle.seconds + seconds_at(set, cycle, 0.25), 1e-14);
}

// A pelvis that sways by sines while it walks on at 1.3 m/s.
Pose swaying(const MotionSet& set, double seconds) {
  Pose pose;
  pose.rotations.assign(set.skeleton.joints.size(), Eigen::Quaterniond::Identity());
  const double angle = 2 * M_PI * seconds;
  pose.root << 0.02 * std::sin(angle), 0.9 + 0.01 * std::cos(2 * angle), 7 + 1.3 * seconds;
  return pose;
}

TEST(CanonicalCycle, KeepsTravelApartAsVelocity) {
  const MotionSet set = toy_set(1, 60);
  const Cycle cycle = canonical_cycle(set, {0, 0.4, 0.5, 0.9, 1},
                                      [&](double seconds) { return swaying(set, seconds); });
  EXPECT_NEAR(cycle.velocity.x(), 0, 1e-15);
  EXPECT_NEAR(cycle.velocity.y(), 1.3, 1e-14);
  EXPECT_NEAR(cycle.root(0, 15), 0.02, 1e-15);
  EXPECT_NEAR(cycle.root(1, 0), 0.91, 1e-15);
  EXPECT_LT(cycle.root.row(2).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(CanonicalCycle, SwayHasNoMeanOverTime) {
  MotionSet set = toy_set(1, 60);
  const Cycle cycle = canonical_cycle(set, {0, 0.3, 0.5, 0.9, 1},
                                      [&](double seconds) { return swaying(set, seconds + 0.1); });
  double mean = 0;
  for (int k = 0; k < 6000; ++k) {
    mean += pose_at(set, cycle, phase_at(set, cycle, (k + 0.5) / 6000)).root.x() / 6000;
  }
  EXPECT_NEAR(mean, 0, 1e-6);
}

}  // namespace
}  // namespace promenade::motion
