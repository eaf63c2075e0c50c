// Feet that stand do not slide. Planting them, and measuring how well a loop
// closes and its feet stand, for captured, generated and blended cycles alike.
//
// A foot stands from its "on" to its "off" keytime. It is held by its heel or ankle first
// (it turns about the heel until it is flat) and by its toe once the heel comes up; where
// that changes is seen in the motion.
#pragma once

#include "motion/leg_ik.h"
#include "motion/motion_set.h"

namespace promenade::motion {

struct PlantReport {
  double moved_m = 0;       // the most that an ankle was moved
  double lowered_m = 0;     // the most that the pelvis was lowered so that legs reach
  double speed_change = 0;  // m/s: the walk's speed is that of its feet, within 4 %
};

// Moves the ankles of a cycle over the ground so that its standing feet stay where
// they are while the body walks on; what was moved fades out during the swing. Both feet
// stand at one height, and one that sinks below it is lifted. Feet keep their directions but for a
// little more heel rise before they leave. For walks only.
PlantReport plant_feet(const MotionSet& set, Cycle& cycle);

// How far the supporting point of a foot slides over the ground while it stands: the
// path of the one of heel, ankle, toe and the ground under the heel that moves least,
// step by step, metres.
double stance_slide_m(const MotionSet& set, const Cycle& cycle, Side side);

// The height at which toes stand when they are lowest (in a tenth of their stance; the mean of
// both feet), metres: the floor is as far below as soles are thick.
double toe_level(const MotionSet& set, const Cycle& cycle);
double toe_level(const MotionSet& set, const Cycle& cycle, Side side);  // of one foot

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
