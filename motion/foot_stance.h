// A walk while its feet are planted: its poses, and what its feet do while they stand.
// Used by foot_changes and foot_plant only.
#pragma once

#include "motion/heel.h"
#include "motion/leg_ik.h"
#include "motion/motion_set.h"

namespace promenade::motion {

// Phases of a stance, the second beyond F where it runs over the seam.
struct StancePhases {
  int on = 0, off = 0;
};

StancePhases stance_phases(const MotionSet& set, Side side);

// A cycle while its feet are planted: the poses of its phases, and what they look like.
struct Walk {
  const MotionSet& set;
  const Cycle& cycle;
  std::vector<Pose> poses;        // F
  std::vector<WorldPose> worlds;  // F, before anything is moved
  std::vector<double> times;      // F + 1, seconds

  int phases() const { return set.phases; }
  std::size_t wrapped(int f) const { return static_cast<std::size_t>(f % phases()); }
  double time(int f) const {
    const int turns = f / phases();
    return times[wrapped(f)] + turns * cycle.seconds;
  }

  Eigen::Vector3d place(int f, BodyJoint part) const {
    return worlds[wrapped(f)].positions.col(set.body.joint[part]);
  }
};

Walk make_walk(const MotionSet& set, const Cycle& cycle);

// The heel of a foot, as it is at the phase of its stance where it is flattest: where the
// ankle is lowest.
Heel heel_of(const Walk& walk, const StancePhases& stance, const LegJoints& leg);

// One step of a stance, from phase to phase over the ground: left and ahead, metres.
struct FootStep {
  Eigen::Vector2d sole, toe;  // sole: the one of heel and ankle that moves less
};

// A foot that strikes with its heel turns about it until it is flat. Then heel and ankle
// stand both, and at last the toe alone.
std::vector<FootStep> foot_steps(const Walk& walk, const StancePhases& stance,
                                 const LegJoints& leg);

// The step from which on a foot stands by its toe: where all together move least.
std::size_t heel_off(const std::vector<FootStep>& steps);

// 2 x (phases of the stance): how far the ankle must be moved so that the foot stands,
// with mean 0 over the stance.
Eigen::Matrix2Xd stance_shift(const std::vector<FootStep>& steps);

// Never less than the values (F), and smooth in time around the cycle.
std::vector<double> smooth_cover(const Walk& walk, const std::vector<double>& values);

}  // namespace promenade::motion
