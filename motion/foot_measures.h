// How well a loop closes and its feet stand, for captured, generated and blended cycles
// alike.
#pragma once

#include "motion/leg_ik.h"
#include "motion/motion_set.h"

namespace promenade::motion {

// How far the supporting point of a foot slides over the ground while it stands: the
// path of the one of heel, ankle, toe and the ground under the heel that moves least,
// step by step, metres.
double stance_slide_m(const MotionSet& set, const Cycle& cycle, Side side);

// The height at which toes stand when they are lowest (in a tenth of their stance; the mean of
// both feet), metres: the floor is as far below as soles are thick.
double toe_level(const MotionSet& set, const Cycle& cycle);
double toe_level(const MotionSet& set, const Cycle& cycle, Side side);  // of one foot

// Where standing toes are brought to: where the takes have them, but within what shoes and bare
// feet can have. Metres over the floor.
double floor_level(double toe_level_m);

// The most that a toe or heel comes below that level at any time, metres.
double penetration_m(const MotionSet& set, const Cycle& cycle);

// What happens where the last pose meets the first. A gap is how far a joint lies from
// where its own motion would bring it (the second difference of its positions, in steps
// of `step_s`): both a jump in position and one in velocity show in it.
struct Seam {
  double step_s = 1.0 / 60;
  double gap_m = 0;         // the largest of any joint, at the seam
  double inside_m = 0;      // the largest of any joint, anywhere else
  double position_m = 0;    // the pose just before against just after: largest of any joint
  double velocity_m_s = 0;  // change of velocity at the seam, largest of any joint
};
Seam seam(const MotionSet& set, const Cycle& cycle);

// 3 x 20, metres: the body walking over the ground, at a time that may lie beyond the
// cycle.
Eigen::Matrix<double, 3, body_joint_count> body_over_ground(const MotionSet& set,
                                                            const Cycle& cycle, double seconds);

}  // namespace promenade::motion
