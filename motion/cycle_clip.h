// A cycle as a clip, to be written as BVH.
#pragma once

#include "motion/clip.h"
#include "motion/motion_set.h"

namespace promenade::motion {

// In metres, Y up, walking along +Z over the ground. As many frames as the cycle had
// in its source (at 60 a second if it was made), and the closing one: the last pose is
// the first, one cycle further on.
Clip cycle_clip(const MotionSet& set, const Cycle& cycle);

// The same so many times in a row, at least once, as a capture shows a walk: the way goes on,
// and the closing frame comes once, at the end.
Clip repeated_clip(Clip clip, int times);

}  // namespace promenade::motion
