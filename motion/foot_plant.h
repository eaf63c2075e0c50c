// Feet that stand do not slide.
//
// A foot stands from its "on" to its "off" keytime. It is held by its heel or ankle first
// (it turns about the heel until it is flat) and by its toe once the heel comes up; where
// that changes is seen in the motion.
#pragma once

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

}  // namespace promenade::motion
